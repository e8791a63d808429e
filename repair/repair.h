// Repair: Grouper, Isect, Coplanar and orientation, until the second lint is empty (paper 3.1 to 3.3).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "repair/surface_order.h"
#include "scene/conforming_model.h"
#include "scene/coplanar_removal.h"
#include "scene/filter.h"
#include "scene/ledger.h"
#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::repair {

struct RepairOptions {
  std::optional<geom::ToleranceRequest> tolerance;  ///< nothing: the default of the scene
  /// Filters to run, of kRepairFilters. Orient works on the input, which Grouper asks to be consistent (1b), and on the
  /// result. With none the faces are only put together, whatever is wrong with them.
  scene::FilterSet filters = scene::kRepairFilters;
  bool stage = false;        ///< make Repaired::stage
  CoplanarOptions coplanar;  ///< which face is visible where several overlap
  /// Called between rounds with the stage and how many violations are left; false stops.
  std::function<bool(const char* stage, std::size_t left)> progress;
};

/// Area of all faces after a filter, file units².
struct StageArea {
  std::string stage;  ///< "input" before the first
  double area = 0;
};

struct Repaired {
  bool untouched = false;  ///< the model was fit as it was
  /// Empty where nothing has an area. Overlaps are in it where Coplanar did not run.
  scene::ConformingModel model;
  std::optional<scene::Scene> turned;  ///< the input with faces turned, where nothing else was to be done
  std::optional<scene::Scene> stage;   ///< with a record (scene/stage_record.h), where asked for
  scene::Ledger ledger;                ///< in running order; empty where untouched
  scene::CoplanarRemovals removals;    ///< what Coplanar removed, largest area first
  scene::StageTimings timings;         ///< on the wall
  scene::StageTimings cpu_timings;     ///< of all threads
  std::vector<StageArea> areas;        ///< in running order, of the pass that counts
  std::size_t unresolved = 0;          ///< violations that are left in the triangles, and places that drifted
  std::size_t drifted = 0;             ///< places where a surface is farther than 8 T from where it was
  scene::dvec3 drifted_at{0, 0, 0};    ///< file units; one of them
  bool interrupted = false;
  std::string refusal;     ///< why the tolerance cannot be used; then nothing was done
  std::string impossible;  ///< why the filters asked for cannot run on this model; then nothing was done
};

/// Repairs `scene`, of which `issues` were reported. No point moves more than 4 T outside of what is merged locally.
/// The result depends neither on the order of faces nor on the number of threads. Where `scene` comes from a stage file
/// of the filter before, the filters go on from what it holds: one by one they give what they give in one run, unless
/// that climbs the ladder or needs more than one pass.
Repaired repair(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options);

}  // namespace rad::repair
