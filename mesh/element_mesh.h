// The element meshing library (paper 3.4.2): tri-quad trees over the patches, balanced and anchored within surfaces.
#pragma once

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
  std::uint32_t face = 0;  ///< patches of one face lie in one plane
  dvec3 normal{0, 0, 0};   ///< unit length, to the front
  double face_area = 0;    ///< file units²
  scene::MaterialId material = 0;
  scene::ObjectId object = 0;
  scene::GroupId group = 0;
  std::uint32_t origin = 0;  ///< face of the conforming model that was meshed
  bool whole = false;        ///< not to be divided
};

/// Patches as the library takes them: from Pmesh, or made by hand. Patches that have two nodes in common, in opposite
/// order, are neighbours within a surface; at other edges a surface ends, and where two surfaces meet the nodes of both
/// lie at the same points.
struct ElementPatches {
  geom::Lattice lattice;
  geom::Tolerance tolerance;
  std::vector<geom::LatticePoint> points;  ///< distinct
  std::vector<std::uint32_t> node_point;   ///< per node an index into `points`
  std::vector<Corners> corners;            ///< per patch: a triangle or a strictly convex quadrilateral
  std::vector<PatchSource> sources;        ///< per patch
};
ElementPatches element_patches(const PatchMesh& patches);

/// Append-only: nodes, elements and points that exist never change, so that they may be read while nothing is refined.
/// About 30 bytes an element with its nodes (memory_bytes()). Neighbours, anchors and the nodes in the middle of edges
/// are not stored: they follow from the trees and from the neighbours of the patches.
class ElementMesh {
 public:
  explicit ElementMesh(ElementPatches patches);
  explicit ElementMesh(const PatchMesh& patches) : ElementMesh(element_patches(patches)) {}

  [[nodiscard]] std::size_t patch_count() const { return roots_.size(); }
  [[nodiscard]] std::size_t node_count() const { return node_point_.size(); }
  [[nodiscard]] std::size_t element_count() const { return roots_.size() + 4 * blocks_.size(); }
  /// Of everything that grows with the number of elements, as it is filled.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Divides leaves in four, and with them the coarser neighbours that would differ by more than one level from a new
  /// leaf, and leaves left with a middle on every edge. Elements stay where their children, or the pieces of a
  /// neighbour that they would anchor, would be narrower than the least spacing, and with them the neighbours that
  /// would force their division. Ids of elements that are no leaves are ignored. The same mesh, with the same ids,
  /// whatever the order of `elements` and the number of threads. Returns the new nodes.
  NodeRange refine(std::span<const ElementId> elements);

  /// In the order of patches, then of children.
  [[nodiscard]] std::vector<ElementId> leaves() const;
  [[nodiscard]] bool is_leaf(ElementId element) const { return children(element) == kNoBlock; }
  /// The children of an element that is no leaf are this one and the three next: child k has corner k of the element,
  /// and the fourth of a triangle lies in its middle.
  [[nodiscard]] ElementId first_child(ElementId element) const {
    return static_cast<ElementId>(roots_.size()) + 4 * children(element);
  }
  [[nodiscard]] Corners corners(ElementId element) const;
  [[nodiscard]] std::uint32_t level(ElementId element) const;
  [[nodiscard]] PatchId patch_of(ElementId element) const;
  /// Leaves on the other side of an edge of a leaf within the surface: none at its border, one, or two finer ones.
  [[nodiscard]] std::vector<ElementId> neighbours(ElementId leaf, std::uint32_t edge) const;
  /// The patch of the same surface at the other side of an edge of a patch, or kNoElement.
  [[nodiscard]] PatchId patch_across(PatchId patch, std::uint32_t edge) const {
    return roots_[patch].across[edge].element;
  }
  /// What a leaf is split into so that no node lies inside one of its edges.
  [[nodiscard]] AnchoredPieces anchored(ElementId leaf) const;

  /// Index into points(), of a node.
  [[nodiscard]] std::uint32_t point_of(NodeId node) const { return node_point_[node]; }
  [[nodiscard]] const std::vector<geom::LatticePoint>& points() const { return points_; }
  /// Points of any surface inside the edge from `a` to `b` of an anchored piece, in this order: there are some only at
  /// the border of a surface, where another is divided more finely.
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
  /// An edge of an element seen from its neighbour.
  struct Side {
    ElementId element = kNoElement;
    std::uint32_t edge = 0;
  };
  struct Root {
    Corners corners;
    BlockId children = kNoBlock;
    std::array<Side, 4> across;  ///< patches at the other side of its edges
  };
  class Closure;
  class Batch;

  [[nodiscard]] BlockId children(ElementId element) const;
  [[nodiscard]] BlockId& children_slot(ElementId element);
  [[nodiscard]] std::uint32_t corner_count(ElementId element) const;
  [[nodiscard]] bool is_root(ElementId element) const { return element < roots_.size(); }
  [[nodiscard]] const Block& block_of(ElementId element) const { return blocks_[(element - roots_.size()) / 4]; }
  [[nodiscard]] std::uint32_t slot_of(ElementId element) const {
    return static_cast<std::uint32_t>(element - roots_.size()) % 4;
  }

  void connect_roots();
  /// The element of the same level, or a coarser leaf, at the other side of an edge.
  [[nodiscard]] Side across(ElementId element, std::uint32_t edge) const;
  [[nodiscard]] NodeId middle(ElementId element, std::uint32_t edge) const;
  [[nodiscard]] ElementId coarser_neighbour(ElementId element, std::uint32_t edge) const;
  void add_leaves(ElementId element, std::vector<ElementId>& leaves) const;
  void add_edge_points(std::uint32_t a, std::uint32_t b, double from, double to, std::vector<EdgePoint>& points) const;

  void limit_levels();
  [[nodiscard]] std::array<dvec3, 4> corner_places(ElementId element) const;
  [[nodiscard]] double width(ElementId element) const;
  [[nodiscard]] double width_across(ElementId element, std::uint32_t edge) const;
  [[nodiscard]] double certain_width(ElementId element) const;
  [[nodiscard]] bool large_enough(ElementId element) const;
  [[nodiscard]] bool neighbours_large_enough(ElementId element) const;
  [[nodiscard]] std::vector<ElementId> enclosed_by(std::span<const ElementId> divided) const;
  void divide(std::span<const ElementId> elements);

  geom::Lattice lattice_;
  geom::Tolerance tolerance_;
  std::vector<geom::LatticePoint> points_;
  std::vector<PatchSource> sources_;
  std::vector<Root> roots_;
  std::vector<std::uint32_t> deepest_;  ///< per patch: the level below which its elements are not divided
  std::vector<float> certain_width_;    ///< per patch: its elements of level n are 2^-n of this wide at least, pitches
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> node_point_;
  PairTable<std::uint32_t> middle_points_;  ///< of edges at the border of a surface, by their points
  std::vector<std::uint8_t> answers_;       ///< per element, of the batch at hand
};

}  // namespace rad::mesh
