// The stages of radfix after reading: repair, mesh, solve, bake.
#pragma once

#include <optional>
#include <string>

#include "cli/judge.h"
#include "cli/light_map_stage.h"
#include "cli/live_line.h"
#include "cli/options.h"
#include "cli/repair_run.h"
#include "report/repair_report.h"
#include "scene/vertex_light.h"

namespace rad::cli {

/// What is to be written, and what was done on the way.
struct Product {
  scene::Scene scene;
  std::optional<scene::VertexLight> light;
  std::optional<BakedLightMap> light_map;  ///< with light
  std::optional<scene::Scene> patches;     ///< for a picture that shows them
  scene::RecordedLattice lattice;
  report::RepairDone repair = report::RepairDone::Not;
  bool incomplete = false;  ///< a stage was stopped before its end
  RepairRun work;
  scene::Ledger left_out;  ///< of faces that were left out before repair, as asked
  scene::StageTimings timings;
  std::optional<report::MeshFigures> mesh;
  std::optional<report::SolutionFigures> solution;
  int exit_code = 0;    ///< not 0 where there is nothing to write
  std::string problem;  ///< then why
};

/// Runs the stages that the command asks for.
Product make_product(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
                     const InterruptWatch& watch);

}  // namespace rad::cli
