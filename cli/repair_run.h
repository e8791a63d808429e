// Repair under its contract: what a filter makes worse is not used.
#pragma once

#include <functional>
#include <string>

#include "cli/judge.h"
#include "cli/live_line.h"
#include "cli/options.h"
#include "repair/repair.h"
#include "scene/repaired_scene.h"

namespace rad::cli {

struct RepairRun {
  repair::Repaired repaired;
  /// What is to be written where nothing is meshed, and of which faces of the model it is made. Empty lists where it is
  /// the input, face by face.
  scene::PiecesOfModel pieces;
  bool input_as_it_was = false;
  scene::FilterSet done;               ///< filters whose work is used
  std::vector<std::string> rolled_back;  ///< a sentence for each filter whose work is not
  bool all_rolled_back = false;
};

/// What the result is for.
struct RepairTarget {
  bool triangles = false;  ///< of a format that holds nothing else, or of the mesh
  bool stage = false;      ///< a stage file
};

/// How a model is repaired.
using RepairFunction = std::function<repair::Repaired(const scene::Scene& scene, const scene::ReadIssues& issues,
                                                      const repair::RepairOptions& options)>;

/// Runs the filters of the command. Where the result has more places in error than the input, by any rule that a later
/// filter is not there to cure, the last filter is left out and the rest runs again; the ledger says so.
RepairRun run_repair(const Model& model, const FixCommand& command, const RepairTarget& target, LiveLine& line,
                     const InterruptWatch& watch, const RepairFunction& repair = &repair::repair);

}  // namespace rad::cli
