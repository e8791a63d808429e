// The sector of a surface around a node: its normal, and the direction into its middle.
#pragma once

#include <span>
#include <vector>

#include "mesh/radiosity_mesh.h"

namespace rad::mesh {

/// A corner of an element at a node: the sector turns counter-clockwise from the way to `next` to the way to `previous`.
struct NodeCorner {
  NodeId node = 0;
  NodeId next = 0;
  NodeId previous = 0;
  std::uint32_t face = 0;
  double face_area = 0;
  dvec3 normal{0, 0, 0};
};

/// Mean of the normals of the faces at one node, each weighted with its area; exactly the normal where they agree.
dvec3 node_normal(std::span<const NodeCorner> corners);

/// Unit direction, at right angles to `normal`, from the node into the middle of its sector: after half the angle from
/// its first edge to its last. Zero where the corners close around the node.
dvec3 inward_direction(std::span<const NodeCorner> corners, const dvec3& normal, std::span<const Node> nodes);

}  // namespace rad::mesh
