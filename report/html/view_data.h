// What the script of the page knows of a model, as JSON.
#pragma once

#include "report/html/model_view.h"
#include "report/json_parts.h"
#include "scene/finding.h"

namespace rad::report::html {

/// Coordinates are those of a cube from -1 to 1 around the geometry's box: (p - low) / (step · kSteps) · 2 - 1.
///   up, camera {position, target, fieldOfView}, triangles, leftOut, unitsPerHalf (file units)
///   faults[]: severity, rule, camera or null, points [x, y, z, …], lines [x, y, z, x, y, z, …],
///             triangles [first, count, …]
/// `findings` are those of `view.faults`, in order.
Json view_json(const ModelView& view, const std::vector<const scene::Finding*>& findings);

}  // namespace rad::report::html
