// Every face of a scene as triangles, for drawing: also of models that no rule would let pass.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace rad::bake {

/// A triangle of a face, turned as the face is. `outline[i]` tells whether the edge from corner i to corner i+1 is an
/// edge of the face.
struct DrawnTriangle {
  std::array<scene::VertexId, 3> corners;
  std::array<bool, 3> outline{true, true, true};
  scene::FaceId face = 0;
};

/// The triangles of all faces, in the order of the faces. Convex quadrilaterals are split along the shorter diagonal.
/// A face that crosses itself is shown as the fan of its outer loop; faces with a corner that is not finite, or with
/// fewer than three, are left out.
std::vector<DrawnTriangle> drawn_triangles(const scene::Scene& scene);

}  // namespace rad::bake
