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

// Per child and edge inside the parent: the child across, and its edge. Edges on the parent's edges are absent.
struct Inside {
  std::uint32_t child = 4;
  std::uint32_t edge = 0;
};
constexpr std::array<std::array<Inside, 4>, 4> kTriangleInside{
    {{{{}, {3, 2}, {}, {}}}, {{{}, {}, {3, 0}, {}}}, {{{3, 1}, {}, {}, {}}}, {{{1, 2}, {2, 0}, {0, 1}, {}}}}};
constexpr std::array<std::array<Inside, 4>, 4> kQuadInside{
    {{{{}, {1, 3}, {3, 0}, {}}}, {{{}, {}, {2, 0}, {0, 1}}}, {{{1, 2}, {}, {}, {3, 1}}}, {{{0, 2}, {2, 3}, {}, {}}}}};

PatchSource source_of(const PatchMesh& patches, std::uint32_t face) {
  const PatchedFace& from = patches.faces[face];
  return {face, from.normal, from.area, from.material, from.object, from.group, from.origin, from.whole};
}

}  // namespace

ElementPatches element_patches(const PatchMesh& patches) {
  ElementPatches result{patches.lattice, patches.tolerance, patches.points, {}, {}, {}};
  for (const auto vertex : patches.patches.vertices()) {
    result.node_point.push_back(patches.patches.data(vertex).lattice_point);
  }
  for (const auto face : patches.patches.faces()) {
    Corners corners{{}, 0};
    for (const auto vertex : face.vertices()) corners.node[corners.count++] = static_cast<NodeId>(vertex.idx());
    result.corners.push_back(corners);
    result.sources.push_back(source_of(patches, patches.patches.data(face).face));
  }
  return result;
}

ElementMesh::ElementMesh(ElementPatches patches)
    : lattice_(patches.lattice),
      tolerance_(patches.tolerance),
      points_(std::move(patches.points)),
      sources_(std::move(patches.sources)),
      node_point_(std::move(patches.node_point)) {
  for (const Corners& corners : patches.corners) roots_.push_back({corners, kNoBlock, {}});
  connect_roots();
  limit_levels();
}

void ElementMesh::connect_roots() {
  struct Use {
    std::array<NodeId, 2> ends;
    ElementId root;
    std::uint32_t edge;
    bool forward;
  };
  std::vector<Use> uses;
  for (ElementId root = 0; root < roots_.size(); ++root) {
    const Corners& corners = roots_[root].corners;
    for (std::uint32_t edge = 0; edge < corners.count; ++edge) {
      const NodeId a = corners.node[edge], b = corners.node[(edge + 1) % corners.count];
      uses.push_back({{std::min(a, b), std::max(a, b)}, root, edge, a < b});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return a.ends != b.ends ? a.ends < b.ends : a.root < b.root; });
  for (std::size_t i = 1; i < uses.size(); ++i) {
    const Use &a = uses[i - 1], &b = uses[i];
    if (a.ends != b.ends || a.forward == b.forward) continue;
    roots_[a.root].across[a.edge] = {b.root, b.edge};
    roots_[b.root].across[b.edge] = {a.root, a.edge};
  }
}

std::size_t ElementMesh::memory_bytes() const {
  return blocks_.size() * sizeof(Block) + roots_.size() * (sizeof(Root) + sizeof(PatchSource)) + answers_.size() +
         points_.size() * sizeof(geom::LatticePoint) + node_point_.size() * sizeof(std::uint32_t) +
         middle_points_.memory_bytes();
}

ElementMesh::BlockId ElementMesh::children(ElementId element) const {
  return is_root(element) ? roots_[element].children : block_of(element).children[slot_of(element)];
}

ElementMesh::BlockId& ElementMesh::children_slot(ElementId element) {
  if (is_root(element)) return roots_[element].children;
  return blocks_[(element - roots_.size()) / 4].children[slot_of(element)];
}

std::uint32_t ElementMesh::corner_count(ElementId element) const {
  return is_root(element) ? roots_[element].corners.count : block_of(element).corner_count;
}

Corners ElementMesh::corners(ElementId element) const {
  if (is_root(element)) return roots_[element].corners;
  const Block& block = block_of(element);
  Corners corners;
  corners.count = block.corner_count;
  const auto& slots = (block.corner_count == 3 ? kTriangleChildren : kQuadChildren)[slot_of(element)];
  for (std::uint32_t i = 0; i < corners.count; ++i) corners.node[i] = block.node[slots[i]];
  return corners;
}

std::uint32_t ElementMesh::level(ElementId element) const { return is_root(element) ? 0U : block_of(element).level; }

PatchId ElementMesh::patch_of(ElementId element) const { return is_root(element) ? element : block_of(element).patch; }

// Across an edge on the parent's edge lies a child of what is across there: the halves of the edge run opposite ways.
ElementMesh::Side ElementMesh::across(ElementId element, std::uint32_t edge) const {
  if (is_root(element)) return roots_[element].across[edge];
  const Block& block = block_of(element);
  const std::uint32_t slot = slot_of(element);
  const Inside& inside = (block.corner_count == 3 ? kTriangleInside : kQuadInside)[slot][edge];
  if (inside.child < 4) return {element - slot + inside.child, inside.edge};
  const Side coarse = across(block.parent, edge);
  if (coarse.element == kNoElement || is_leaf(coarse.element)) return coarse;
  const std::uint32_t child = slot == edge ? (coarse.edge + 1) % corner_count(coarse.element) : coarse.edge;
  return {first_child(coarse.element) + child, coarse.edge};
}

ElementId ElementMesh::coarser_neighbour(ElementId element, std::uint32_t edge) const {
  const Side side = across(element, edge);
  return side.element != kNoElement && level(side.element) < level(element) ? side.element : kNoElement;
}

NodeId ElementMesh::middle(ElementId element, std::uint32_t edge) const {
  const Side side = across(element, edge);
  if (side.element == kNoElement || level(side.element) < level(element)) return kNoNode;
  const BlockId block = children(side.element);
  return block == kNoBlock ? kNoNode : blocks_[block].node[4 + side.edge];
}

std::vector<ElementId> ElementMesh::leaves() const {
  std::vector<ElementId> leaves;
  leaves.reserve(roots_.size() + 3 * blocks_.size());
  for (ElementId root = 0; root < roots_.size(); ++root) add_leaves(root, leaves);
  return leaves;
}

void ElementMesh::add_leaves(ElementId element, std::vector<ElementId>& leaves) const {
  if (is_leaf(element)) {
    leaves.push_back(element);
    return;
  }
  const ElementId first = first_child(element);
  for (ElementId slot = 0; slot < 4; ++slot) add_leaves(first + slot, leaves);
}

std::vector<ElementId> ElementMesh::neighbours(ElementId leaf, std::uint32_t edge) const {
  const Side side = across(leaf, edge);
  if (side.element == kNoElement) return {};
  if (is_leaf(side.element)) return {side.element};
  const ElementId first = first_child(side.element);
  return {first + (side.edge + 1) % corner_count(side.element), first + side.edge};
}

AnchoredPieces ElementMesh::anchored(ElementId leaf) const {
  const Corners own = corners(leaf);
  std::array<NodeId, 4> middles{kNoNode, kNoNode, kNoNode, kNoNode};
  for (std::uint32_t edge = 0; edge < own.count; ++edge) middles[edge] = middle(leaf, edge);
  return anchored_pieces(own, middles);
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
