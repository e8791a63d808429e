// Level rectangles, and scenes of faces that are given by their corners.
#pragma once

#include <vector>

#include "tests/support/derived_scene.h"

namespace rad::tests {

inline std::vector<scene::dvec3> sheet(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

inline scene::Scene sketched(const std::vector<std::vector<scene::dvec3>>& faces) {
  SceneSketch sketch;
  for (const auto& face : faces) sketch.face(face);
  return sketch.take();
}

}  // namespace rad::tests
