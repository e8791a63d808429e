// The repaired faces as polygons, as far as polygons say what repair has proven.
#pragma once

#include <vector>

#include "scene/repaired_scene.h"

namespace rad::cli {

/// One flag for each face of the model: whether others touch it along edges inside it. A polygon has no place for
/// those.
std::vector<bool> faces_with_inner_edges(const scene::ConformingModel& model);

/// The faces of `model` as polygons. A face with inner edges goes out as its triangles; so does one that lint of the
/// polygons, holes bridged as the writers bridge them, faults at stages model or display, because what is triangulated
/// anew is not what repair has proven.
scene::PiecesOfModel faces_to_write(const scene::ConformingModel& model, const scene::Scene& origin);

}  // namespace rad::cli
