// The repaired faces as polygons, as far as polygons say what repair has proven.
#pragma once

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::cli {

/// The faces of `model` as polygons, holes bridged as the writers bridge them. A face that touches others along edges
/// inside it goes out as its triangles, since a polygon has no place for those edges; so does one that lint of the
/// polygons faults at stages model or display, because what is triangulated anew is not what repair has proven.
scene::Scene faces_to_write(const scene::ConformingModel& model, const scene::Scene& origin);

}  // namespace rad::cli
