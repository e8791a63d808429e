// The anchored and ziplocked leaves of an element mesh: what is written and shown.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/radiosity_mesh.h"

namespace rad::mesh {

/// A vertex of the display mesh: a node, or a point between two nodes of one surface where only the surface on the
/// other side of the edge has a node (ziplocking: the geometry is fused, the value is interpolated).
struct DisplayVertex {
  geom::LatticePoint point;
  std::array<NodeId, 2> node{};  ///< equal for a node
  double share = 0;              ///< value = (1 - share) · value(node[0]) + share · value(node[1])
};

/// A triangle or a strictly convex quadrilateral; `corner` are indices of display vertices.
struct DisplayFace {
  std::array<std::uint32_t, 4> corner{};
  std::uint32_t count = 3;
  PatchId patch = 0;
  scene::MaterialId material = 0;
  scene::ObjectId object = 0;
  scene::GroupId group = 0;
};

struct DisplayMesh {
  std::vector<DisplayVertex> vertices;
  std::vector<DisplayFace> faces;
};

}  // namespace rad::mesh
