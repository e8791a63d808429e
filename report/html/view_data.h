// What the script of the page knows of a model, as JSON.
#pragma once

#include "report/html/model_view.h"
#include "report/json_parts.h"
#include "scene/finding.h"

namespace rad::report::html {

/// Coordinates are those of a cube from -1 to 1 around the box of `frame`: (p - low) / (step · kSteps) · 2 - 1.
///   up, camera {position, target, fieldOfView}, triangles, leftOut
///   place {scale, offset}: takes the cube of the view's own geometry to that of `frame`
///   faults[]: severity, rule, camera or null, points [x, y, z, …], lines [x, y, z, x, y, z, …],
///             triangles [first, count, …]
/// `findings` are those of `view.faults`, in order.
Json view_json(const ModelView& view, const std::vector<const scene::Finding*>& findings, const PackedGeometry& frame);

/// Bytes of a model for the script of the page, in an element of this class.
std::string data_element(std::string_view name, const std::string& bytes, std::size_t model, std::string_view side);

/// Script elements with the view data and the geometry of a model, for `side` "now" or "old".
std::string view_elements(const ModelView& view, const std::vector<const scene::Finding*>& findings,
                          const PackedGeometry& frame, std::size_t model, std::string_view side);

}  // namespace rad::report::html
