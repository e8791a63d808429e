#include "mesh/element_mesh.h"

#include <algorithm>

#include "mesh/patch_mesh.h"

namespace rad::mesh {
namespace {

// Corners of the children by the nodes of a block. Edge k of a child lies on edge k of its parent or inside the parent.
constexpr std::array<std::array<std::uint32_t, 4>, 4> kTriangleChildren{
    {{0, 4, 6, 0}, {4, 1, 5, 0}, {6, 5, 2, 0}, {4, 5, 6, 0}}};
constexpr std::array<std::array<std::uint32_t, 4>, 4> kQuadChildren{
    {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}}};

bool on_parent_edge(std::uint32_t slot, std::uint32_t edge, std::uint32_t corner_count) {
  return edge == slot || (slot < corner_count && edge == (slot + corner_count - 1) % corner_count);
}

// Half of a sum, halves to the even number: rounding over and over does not drift.
std::int32_t halved(std::int64_t sum) {
  const std::int64_t floor = sum >> 1;
  return static_cast<std::int32_t>(floor + (sum & floor & 1));
}

std::int32_t quartered(std::int64_t sum) { return static_cast<std::int32_t>((sum + 2) >> 2); }

PatchSource source_of(const PatchMesh& patches, std::uint32_t face) {
  const PatchedFace& from = patches.faces[face];
  return {face, from.normal, from.area, from.material, from.object, from.group, from.origin, from.whole};
}

}  // namespace

ElementMesh::ElementMesh(const PatchMesh& patches)
    : lattice_(patches.lattice), tolerance_(patches.tolerance), points_(patches.points) {
  for (const auto vertex : patches.patches.vertices()) {
    node_point_.push_back(patches.patches.data(vertex).lattice_point);
  }
  for (const auto face : patches.patches.faces()) {
    Root root;
    root.corners.count = 0;
    for (const auto vertex : face.vertices()) {
      root.corners.node[root.corners.count++] = static_cast<NodeId>(vertex.idx());
    }
    sources_.push_back(source_of(patches, patches.patches.data(face).face));
    roots_.push_back(root);
  }
  for (ElementId element = 0; element < roots_.size(); ++element) register_edges(element);
  limit_levels();
}

ElementMesh::BlockId ElementMesh::children(ElementId element) const {
  if (element < roots_.size()) return roots_[element].children;
  const std::size_t child = element - roots_.size();
  return blocks_[child / 4].children[child % 4];
}

Corners ElementMesh::corners(ElementId element) const {
  if (element < roots_.size()) return roots_[element].corners;
  const std::size_t child = element - roots_.size();
  const Block& block = blocks_[child / 4];
  Corners corners;
  corners.count = block.corner_count;
  const auto& slots = (block.corner_count == 3 ? kTriangleChildren : kQuadChildren)[child % 4];
  for (std::uint32_t i = 0; i < corners.count; ++i) corners.node[i] = block.node[slots[i]];
  return corners;
}

std::uint32_t ElementMesh::level(ElementId element) const {
  return element < roots_.size() ? 0U : blocks_[(element - roots_.size()) / 4].level;
}

PatchId ElementMesh::patch_of(ElementId element) const {
  return element < roots_.size() ? element : blocks_[(element - roots_.size()) / 4].patch;
}

ElementId ElementMesh::other_side(NodeId from, NodeId to) const {
  const EdgeRecord* edge = edges_.find(from, to);
  return edge == nullptr ? kNoElement : edge->side[from < to ? 1 : 0];
}

ElementId ElementMesh::coarser_neighbour(ElementId element, std::uint32_t edge) const {
  if (element < roots_.size()) return kNoElement;
  const Corners own = corners(element);
  if (other_side(own.node[edge], own.node[(edge + 1) % own.count]) != kNoElement) return kNoElement;
  const std::size_t child = element - roots_.size();
  const Block& block = blocks_[child / 4];
  if (!on_parent_edge(static_cast<std::uint32_t>(child % 4), edge, block.corner_count)) return kNoElement;
  return other_side(block.node[edge], block.node[(edge + 1) % block.corner_count]);
}

void ElementMesh::register_edges(ElementId element) {
  const Corners own = corners(element);
  for (std::uint32_t i = 0; i < own.count; ++i) {
    const NodeId from = own.node[i], to = own.node[(i + 1) % own.count];
    edges_.at(from, to).side[from < to ? 0 : 1] = element;
  }
}

NodeId ElementMesh::add_node(std::uint32_t point) {
  node_point_.push_back(point);
  return static_cast<NodeId>(node_point_.size() - 1);
}

NodeId ElementMesh::middle_node(NodeId a, NodeId b) {
  NodeId& middle = edges_.at(a, b).middle;
  if (middle == kNoNode) middle = add_node(middle_point(node_point_[a], node_point_[b]));
  return middle;
}

// No middle is point 0, which is a corner of the model: 0 marks a new entry.
std::uint32_t ElementMesh::middle_point(std::uint32_t a, std::uint32_t b) {
  std::uint32_t& middle = middle_points_.at(a, b);
  if (middle == 0) {
    const geom::LatticePoint &p = points_[a], &q = points_[b];
    middle = static_cast<std::uint32_t>(points_.size());
    points_.push_back(
        {halved(std::int64_t{p.x} + q.x), halved(std::int64_t{p.y} + q.y), halved(std::int64_t{p.z} + q.z)});
  }
  return middle;
}

void ElementMesh::divide(ElementId element) {
  const Corners own = corners(element);
  Block block;
  block.parent = element;
  block.patch = patch_of(element);
  block.level = static_cast<std::uint16_t>(level(element) + 1);
  block.corner_count = static_cast<std::uint16_t>(own.count);
  for (std::uint32_t i = 0; i < own.count; ++i) {
    block.node[i] = own.node[i];
    block.node[4 + i] = middle_node(own.node[i], own.node[(i + 1) % own.count]);
  }
  if (own.count == 4) {
    std::array<std::int64_t, 3> sum{};
    for (const NodeId node : own.all()) {
      const geom::LatticePoint& p = points_[node_point_[node]];
      sum = {sum[0] + p.x, sum[1] + p.y, sum[2] + p.z};
    }
    points_.push_back({quartered(sum[0]), quartered(sum[1]), quartered(sum[2])});
    block.node[kCentre] = add_node(static_cast<std::uint32_t>(points_.size() - 1));
  }
  const auto id = static_cast<BlockId>(blocks_.size());
  blocks_.push_back(block);
  if (element < roots_.size()) {
    roots_[element].children = id;
  } else {
    const std::size_t child = element - roots_.size();
    blocks_[child / 4].children[child % 4] = id;
  }
  for (ElementId slot = 0; slot < 4; ++slot) register_edges(static_cast<ElementId>(roots_.size()) + 4 * id + slot);
}

std::vector<ElementId> ElementMesh::leaves() const {
  std::vector<ElementId> leaves;
  for (ElementId root = 0; root < roots_.size(); ++root) add_leaves(root, leaves);
  return leaves;
}

void ElementMesh::add_leaves(ElementId element, std::vector<ElementId>& leaves) const {
  const BlockId block = children(element);
  if (block == kNoBlock) {
    leaves.push_back(element);
    return;
  }
  for (ElementId slot = 0; slot < 4; ++slot) {
    add_leaves(static_cast<ElementId>(roots_.size()) + 4 * block + slot, leaves);
  }
}

std::vector<ElementId> ElementMesh::neighbours(ElementId leaf, std::uint32_t edge) const {
  const ElementId coarser = coarser_neighbour(leaf, edge);
  if (coarser != kNoElement) return {coarser};
  const Corners own = corners(leaf);
  std::vector<ElementId> found;
  add_leaves_along(own.node[edge], own.node[(edge + 1) % own.count], found);
  return found;
}

// Leaves on the other side of the edge, by halves where the element there was divided.
void ElementMesh::add_leaves_along(NodeId from, NodeId to, std::vector<ElementId>& leaves) const {
  const ElementId other = other_side(from, to);
  if (other == kNoElement) return;
  if (is_leaf(other)) {
    leaves.push_back(other);
    return;
  }
  const NodeId middle = edges_.find(from, to)->middle;
  add_leaves_along(from, middle, leaves);
  add_leaves_along(middle, to, leaves);
}

std::array<NodeId, 4> ElementMesh::middles(const Corners& corners) const {
  std::array<NodeId, 4> middle{kNoNode, kNoNode, kNoNode, kNoNode};
  for (std::uint32_t i = 0; i < corners.count; ++i) {
    middle[i] = edges_.find(corners.node[i], corners.node[(i + 1) % corners.count])->middle;
  }
  return middle;
}

AnchoredPieces ElementMesh::anchored(ElementId leaf) const {
  const Corners own = corners(leaf);
  return anchored_pieces(own, middles(own));
}

std::vector<EdgePoint> ElementMesh::edge_points(NodeId a, NodeId b) const {
  std::vector<EdgePoint> points;
  add_edge_points(node_point_[a], node_point_[b], 0, 1, points);
  return points;
}

void ElementMesh::add_edge_points(std::uint32_t a, std::uint32_t b, double from, double to,
                                  std::vector<EdgePoint>& points) const {
  const std::uint32_t* middle = middle_points_.find(a, b);
  if (middle == nullptr) return;
  const double share = (from + to) / 2;
  add_edge_points(a, *middle, from, share, points);
  points.push_back({*middle, share});
  add_edge_points(*middle, b, share, to, points);
}

}  // namespace rad::mesh
