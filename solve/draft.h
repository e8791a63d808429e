// A quick estimate of the solution, which tells where the effort of the real one belongs.
#pragma once

#include <span>

#include "scene/scene.h"
#include "solve/coupling_source.h"

namespace rad::solve {

/// Patches receive at their samples only, with few rays; ends where a tenth of the emitted power is unshot, or after as
/// many shots as leave it cheap beside a solution. `source.importance` is not read. The noise of the result is
/// that of the draft.
Importance draft_importance(const CouplingSource& source, std::span<const scene::Material> materials);

}  // namespace rad::solve
