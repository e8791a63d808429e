// The sector of a surface around a node: its normal, and the direction into its middle.
#pragma once

#include <span>
#include <vector>

#include "mesh/element_mesh.h"

namespace rad::mesh {

/// A corner of an element at a node: the sector turns counter-clockwise from the way to `next` to the way to
/// `previous`.
struct NodeCorner {
  NodeId next = 0;
  NodeId previous = 0;
  PatchId patch = 0;
};

/// Looks at the sectors of the nodes of an element mesh, by the positions of `nodes`.
class SectorView {
 public:
  SectorView(const ElementMesh& mesh, std::span<const Node> nodes) : mesh_(mesh), nodes_(nodes) {}

  /// Mean of the normals of the faces at the node, each weighted with its area; exactly the normal where they agree.
  [[nodiscard]] dvec3 normal(std::span<const NodeCorner> corners) const;

  /// Unit direction, in the plane of one of the faces, from the node into the middle of its sector: after half the
  /// angle from its first edge to its last. Zero where the corners close around the node.
  [[nodiscard]] dvec3 inward(NodeId node, std::span<const NodeCorner> corners) const;

 private:
  [[nodiscard]] dvec3 unit_way(NodeId from, NodeId to) const;
  [[nodiscard]] double angle(NodeId node, const NodeCorner& corner) const;

  const ElementMesh& mesh_;
  std::span<const Node> nodes_;
};

}  // namespace rad::mesh
