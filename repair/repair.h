// Repair: Grouper, Isect, Coplanar and orientation, until the second lint is empty (paper 3.1 to 3.3).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "repair/surface_order.h"
#include "scene/conforming_model.h"
#include "scene/coplanar_removal.h"
#include "scene/ledger.h"
#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::repair {

struct RepairOptions {
  std::optional<geom::ToleranceRequest> tolerance;  ///< nothing: the default of the scene
  bool as_it_is = false;                            ///< only put the faces together, whatever is wrong with them
  CoplanarOptions coplanar;                         ///< which face is visible where several overlap
  /// Called between rounds with the stage and how many violations are left; false stops.
  std::function<bool(const char* stage, std::size_t left)> progress;
};

struct Repaired {
  bool untouched = false;            ///< the model was fit as it was
  scene::ConformingModel model;      ///< empty where nothing has an area
  scene::Ledger ledger;              ///< in running order; empty where untouched
  scene::CoplanarRemovals removals;  ///< what Coplanar removed, largest area first
  scene::StageTimings timings;
  std::size_t unresolved = 0;  ///< violations that are left in the triangles
  bool interrupted = false;
  std::string refusal;  ///< why the tolerance cannot be used; then nothing was done
};

/// Repairs `scene`, of which `issues` were reported. No point moves more than 4 T outside of what is merged locally.
/// The result depends neither on the order of faces nor on the number of threads.
Repaired repair(const scene::Scene& scene, const scene::ReadIssues& issues, const RepairOptions& options);

}  // namespace rad::repair
