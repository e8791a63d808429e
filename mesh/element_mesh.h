// The element meshing library (paper 3.4.2): tri-quad trees over the patches, balanced and anchored within surfaces.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geom/lattice.h"
#include "geom/tolerance.h"
#include "mesh/element_anchors.h"
#include "mesh/pair_table.h"
#include "mesh/radiosity_mesh.h"

namespace rad::mesh {

struct PatchMesh;

/// Elements keep their ids; those below the number of patches are the patches themselves.
using ElementId = std::uint32_t;
inline constexpr ElementId kNoElement = 0xffffffffU;

/// Nodes first to last - 1.
struct NodeRange {
  NodeId first = 0;
  NodeId last = 0;
};

/// A point inside an edge between two nodes: an index of ElementMesh::points and its share of the way.
struct EdgePoint {
  std::uint32_t point = 0;
  double share = 0;
};

/// What a patch was made of.
struct PatchSource {
  std::uint32_t face = 0;  ///< index into PatchMesh::faces
  dvec3 normal{0, 0, 0};   ///< unit length, to the front
  double face_area = 0;    ///< file units²
  scene::MaterialId material = 0;
  scene::ObjectId object = 0;
  scene::GroupId group = 0;
  std::uint32_t origin = 0;  ///< face of the conforming model that was meshed
  bool whole = false;        ///< not to be divided
};

/// Append-only: nodes, elements and points that exist never change. Memory about 30 bytes an element.
class ElementMesh {
 public:
  explicit ElementMesh(const PatchMesh& patches);

  [[nodiscard]] std::size_t patch_count() const { return roots_.size(); }
  [[nodiscard]] std::size_t node_count() const { return node_point_.size(); }
  [[nodiscard]] std::size_t element_count() const { return roots_.size() + 4 * blocks_.size(); }

  /// Divides leaves in four, and with them the coarser neighbours that would differ by more than one level from a new
  /// leaf, and leaves left with a middle on every edge. Elements stay where their children, or the pieces of a
  /// neighbour that they would anchor, would be narrower than the least spacing, and with them the neighbours that
  /// would force their division. Ids of elements that are no leaves
  /// are ignored. The same mesh whatever the order of `elements`. Returns the new nodes.
  NodeRange refine(std::span<const ElementId> elements);

  /// In the order of patches, then of children.
  [[nodiscard]] std::vector<ElementId> leaves() const;
  [[nodiscard]] bool is_leaf(ElementId element) const { return children(element) == kNoBlock; }
  [[nodiscard]] Corners corners(ElementId element) const;
  [[nodiscard]] std::uint32_t level(ElementId element) const;
  [[nodiscard]] PatchId patch_of(ElementId element) const;
  /// Leaves on the other side of an edge of a leaf within the surface: none at its border, one, or two finer ones.
  [[nodiscard]] std::vector<ElementId> neighbours(ElementId leaf, std::uint32_t edge) const;
  [[nodiscard]] AnchoredPieces anchored(ElementId leaf) const;

  /// Index into points(), of a node.
  [[nodiscard]] std::uint32_t point_of(NodeId node) const { return node_point_[node]; }
  [[nodiscard]] const std::vector<geom::LatticePoint>& points() const { return points_; }
  /// Points of any surface inside the edge from `a` to `b`, in this order.
  [[nodiscard]] std::vector<EdgePoint> edge_points(NodeId a, NodeId b) const;

  [[nodiscard]] const PatchSource& source(PatchId patch) const { return sources_[patch]; }
  [[nodiscard]] const geom::Lattice& lattice() const { return lattice_; }
  [[nodiscard]] const geom::Tolerance& tolerance() const { return tolerance_; }

 private:
  using BlockId = std::uint32_t;
  static constexpr BlockId kNoBlock = 0xffffffffU;
  static constexpr std::uint32_t kCentre = 8;

  /// The four children of one element. Nodes: corners of the parent, middles of its edges (from slot 4 on), centre.
  struct Block {
    std::array<NodeId, 9> node{};
    ElementId parent = 0;
    std::array<BlockId, 4> children{kNoBlock, kNoBlock, kNoBlock, kNoBlock};
    PatchId patch = 0;
    std::uint16_t level = 0;
    std::uint16_t corner_count = 3;
  };
  struct Root {
    Corners corners;
    BlockId children = kNoBlock;
  };
  /// side[0] is the element whose edge runs from the lower to the higher node, side[1] the other.
  struct EdgeRecord {
    NodeId middle = kNoNode;
    std::array<ElementId, 2> side{kNoElement, kNoElement};
  };
  class Closure;

  [[nodiscard]] BlockId children(ElementId element) const;
  [[nodiscard]] ElementId other_side(NodeId from, NodeId to) const;
  void limit_levels();
  [[nodiscard]] double width(ElementId element) const;
  [[nodiscard]] double width_across(ElementId element, std::uint32_t edge) const;
  [[nodiscard]] bool large_enough(ElementId element) const;
  [[nodiscard]] bool neighbours_large_enough(ElementId element) const;
  [[nodiscard]] ElementId coarser_neighbour(ElementId element, std::uint32_t edge) const;
  void register_edges(ElementId element);
  NodeId middle_node(NodeId a, NodeId b);
  std::uint32_t middle_point(std::uint32_t a, std::uint32_t b);
  NodeId add_node(std::uint32_t point);
  void divide(ElementId element);
  [[nodiscard]] std::array<NodeId, 4> middles(const Corners& corners) const;
  void add_leaves(ElementId element, std::vector<ElementId>& leaves) const;
  void add_leaves_along(NodeId from, NodeId to, std::vector<ElementId>& leaves) const;
  void add_edge_points(std::uint32_t a, std::uint32_t b, double from, double to, std::vector<EdgePoint>& points) const;

  geom::Lattice lattice_;
  geom::Tolerance tolerance_;
  std::vector<geom::LatticePoint> points_;
  std::vector<PatchSource> sources_;
  std::vector<Root> roots_;
  std::vector<std::uint32_t> deepest_;  ///< per patch: the level below which its elements are not divided
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> node_point_;
  PairTable<EdgeRecord> edges_;             ///< of nodes: within surfaces
  PairTable<std::uint32_t> middle_points_;  ///< of points: shared by all surfaces
};

}  // namespace rad::mesh
