// The conforming complex: pieces of faces as chains mod 2 over edges that everybody shares, one cluster for each plane.
//
// An edge carries items. A piece on an edge toggles: twice is not at all. So splitting, merging, collapsing and moving
// a triangle from one plane to another are all toggles, and no loop is ever edited. A cluster on an edge is an imprint:
// something of another plane touches there.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "repair/plane.h"
#include "repair/point_grid.h"
#include "scene/scene.h"

namespace rad::repair {

using ClusterId = std::uint32_t;
using PieceId = std::uint32_t;

/// Two different points, the smaller id in the high half.
using EdgeKey = std::uint64_t;
inline EdgeKey edge_key(PointId a, PointId b) { return a < b ? EdgeKey{a} << 32 | b : EdgeKey{b} << 32 | a; }
inline std::array<PointId, 2> ends_of(EdgeKey key) {
  return {static_cast<PointId>(key >> 32), static_cast<PointId>(key)};
}

/// What an edge carries: a piece, or an imprint in a cluster.
struct Item {
  std::int32_t code = 0;

  static Item piece(PieceId id) { return {static_cast<std::int32_t>(id)}; }
  static Item imprint(ClusterId id) { return {~static_cast<std::int32_t>(id)}; }
  [[nodiscard]] bool is_piece() const { return code >= 0; }
  [[nodiscard]] PieceId piece_id() const { return static_cast<PieceId>(code); }
  [[nodiscard]] ClusterId imprinted_cluster() const { return static_cast<ClusterId>(~code); }
  friend constexpr auto operator<=>(const Item&, const Item&) = default;
};

/// A part of an input face in one plane.
struct Piece {
  ClusterId cluster = 0;
  bool along = true;       ///< its front looks where the cluster's normal points
  std::uint32_t rank = 0;  ///< of its surface: the least wins where surfaces overlap
  scene::FaceId source = 0;
};

struct Cluster {
  Plane plane;
  double area = 0;            ///< of the faces that were claimed for it, pitches²
  std::set<EdgeKey> edges;    ///< that carry one of its pieces or its imprint
  std::set<PointId> points;   ///< imprinted points and Steiner points; ends of imprints too
  std::uint64_t version = 0;  ///< grows with every change of what its triangulation depends on
};

/// What was done, for the ledger.
struct ComplexCounts {
  std::size_t new_points = 0;
  std::size_t splits = 0;
  std::size_t imprints = 0;
  std::size_t merges = 0;
  double largest_merge = 0;  ///< pitches
};

class Complex {
 public:
  /// `tolerance` in pitches: T, or a little more where a first attempt did not end clean.
  explicit Complex(double tolerance);

  /// Adds a point, cluster or piece. Points must be distinct.
  PointId add_point(const LatticePoint& point);
  ClusterId add_cluster(const Plane& plane, double area);
  PieceId add_piece(const Piece& piece);

  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] double weld_distance() const;
  [[nodiscard]] const LatticePoint& point(PointId id) const { return points_[id]; }
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(points_[id]); }
  [[nodiscard]] std::span<const LatticePoint> points() const { return points_; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] std::span<const Cluster> clusters() const { return clusters_; }
  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  [[nodiscard]] ClusterId cluster_of(Item item) const {
    return item.is_piece() ? pieces_[item.piece_id()].cluster : item.imprinted_cluster();
  }
  /// Items of an edge in no particular order; empty where there is no such edge.
  [[nodiscard]] std::span<const Item> items(EdgeKey edge) const;
  [[nodiscard]] bool has_edge(EdgeKey edge) const { return edges_.contains(edge); }
  [[nodiscard]] bool edge_in_cluster(EdgeKey edge, ClusterId cluster) const;
  /// All edges, ascending.
  [[nodiscard]] std::vector<EdgeKey> edges() const;
  /// Whether an edge or an imprint uses the point.
  [[nodiscard]] bool live(PointId id) const { return !neighbours_[id].empty() || !imprinted_in_[id].empty(); }
  [[nodiscard]] bool in_cluster(PointId id, ClusterId cluster) const;
  [[nodiscard]] double length(EdgeKey edge) const;
  [[nodiscard]] double distance(PointId a, PointId b) const;
  /// Whether `a` comes before `b` in space; ids are not looked at.
  [[nodiscard]] bool precedes(PointId a, PointId b) const { return points_[a] < points_[b]; }
  [[nodiscard]] const ComplexCounts& counts() const { return counts_; }

  /// Adds a piece to an edge or takes it off; adds an imprint where it is not there yet.
  void toggle(EdgeKey edge, Item item);
  /// Makes edge (u,v) the two edges (u,w), (w,v). False where there is nothing to split.
  bool split(EdgeKey edge, PointId at);
  /// Whether both halves would be shorter than the edge. Splitting only then is what makes the loops end.
  [[nodiscard]] bool split_shortens(EdgeKey edge, PointId at) const;
  /// Lets `to` take the place of `from` everywhere.
  void merge(PointId from, PointId to);
  /// Merges two points into the one that precedes.
  void merge_into_first(PointId a, PointId b);
  /// Makes the point a point of the cluster; false where it was one.
  bool imprint_point(ClusterId cluster, PointId id);
  /// Takes an imprinted point out that carries no edge of the cluster.
  void drop_point(ClusterId cluster, PointId id);

  /// Forgets dead points in the grid that nearest_point and point_at search.
  void refresh_grid();
  /// The live point nearest to `place` within `reach`, or a new one at the lattice point nearest to it.
  PointId point_at(const dvec3& place, double reach);
  template <typename Visit>
  void for_each_point_near(const dvec3& place, Visit&& visit) const {
    grid_.for_each_near(place, visit);
  }
  /// The largest reach that the grid serves, pitches.
  [[nodiscard]] double grid_reach() const { return grid_.cell(); }

 private:
  void touch(Item item) { ++clusters_[cluster_of(item)].version; }
  void link(EdgeKey edge);
  void unlink(EdgeKey edge);
  [[nodiscard]] PointId nearest(const dvec3& place, double reach) const;

  double tolerance_;
  std::vector<LatticePoint> points_;
  std::vector<Cluster> clusters_;
  std::vector<Piece> pieces_;
  std::unordered_map<EdgeKey, std::vector<Item>> edges_;
  std::vector<std::vector<PointId>> neighbours_;      ///< per point: the other ends of its edges
  std::vector<std::vector<ClusterId>> imprinted_in_;  ///< per point
  PointGrid grid_;
  ComplexCounts counts_;
};

}  // namespace rad::repair
