// The conforming complex: pieces of faces as chains mod 2 over edges that everybody shares, one cluster for each plane.
//
// An edge carries items. A piece on an edge toggles: twice is not at all. So splitting, merging, collapsing and moving
// a triangle from one plane to another are all toggles, and no loop is ever edited. A cluster on an edge is an imprint:
// something of another plane touches there.
#pragma once

#include <tsl/robin_map.h>
#include <tsl/robin_set.h>

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geom/growing_box_tree.h"
#include "repair/plane.h"
#include "repair/point_grid.h"
#include "scene/scene.h"

namespace rad::repair {

using ClusterId = std::uint32_t;
using PieceId = std::uint32_t;

inline constexpr ClusterId kNoCluster = 0xffffffffu;

/// Two different points, the smaller id in the high half.
using EdgeKey = std::uint64_t;
inline EdgeKey edge_key(PointId a, PointId b) { return a < b ? EdgeKey{a} << 32 | b : EdgeKey{b} << 32 | a; }
inline std::array<PointId, 2> ends_of(EdgeKey key) {
  return {static_cast<PointId>(key >> 32), static_cast<PointId>(key)};
}

/// Spreads keys whose low bits are alike.
struct EdgeKeyHash {
  std::size_t operator()(EdgeKey key) const {
    const std::uint64_t mixed = (key ^ (key >> 32)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
  }
};
using EdgeSet = tsl::robin_set<EdgeKey, EdgeKeyHash>;

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

/// The farthest that repair moves a point by merging it, weld distances.
inline constexpr double kFarthestMerge = 4;

inline constexpr std::uint32_t kNoOrigin = 0xffffffffu;

/// A part of an input face in one plane.
struct Piece {
  ClusterId cluster = kNoCluster;  ///< none while it is left as it is
  bool along = true;               ///< its front looks where the cluster's normal points
  std::uint32_t rank = 0;          ///< of its surface: the least wins where surfaces overlap
  scene::FaceId source = 0;
  bool won = false;                  ///< others lay in it and gave way before it came here
  std::uint32_t origin = kNoOrigin;  ///< where its surface was before anything was done
};

struct Cluster {
  Plane plane;
  bool held = false;               ///< it has or had a piece that is held near where it was
  double area = 0;                 ///< of the faces that were claimed for it, pitches²
  EdgeSet edges;                   ///< that carry one of its pieces or its imprint
  tsl::robin_set<PointId> points;  ///< imprinted points and Steiner points; ends of imprints too
  std::uint64_t version = 0;       ///< grows with every change of what its triangulation depends on
  std::vector<EdgeKey> added;      ///< every edge when it became one of these, some more than once

  /// Ascending.
  [[nodiscard]] std::vector<EdgeKey> sorted_edges() const;
};

/// What was done, for the ledger.
struct ComplexCounts {
  std::size_t new_points = 0;
  std::size_t splits = 0;
  std::size_t imprints = 0;
  std::size_t merges = 0;
  std::size_t refused = 0;   ///< splits and merges that would have drawn a surface too far
  double largest_merge = 0;  ///< pitches
};

/// Whether a change may be refused where it draws a surface too far (Complex::keep_near). Without those that keep plane
/// maps from folding nothing can be said about the model any more.
enum class Need : std::uint8_t { Optional, Sound };

class Complex {
 public:
  /// `tolerance` in pitches: T, or a little more where a first attempt did not end clean.
  explicit Complex(double tolerance);

  /// From now on nothing draws a surface farther than `farthest` pitches from where it was, and no merge moves a
  /// point farther: a split, merge or imprint that would is refused. `origins` are the triangles that Piece::origin
  /// names; a piece without is held to its plane. `held` says of each whether that holds for it: for all where it is
  /// empty. To be called before pieces are placed.
  void keep_near(std::vector<std::array<LatticePoint, 3>> origins, double farthest,
                 std::vector<std::uint8_t> held = {});
  [[nodiscard]] const std::vector<std::array<LatticePoint, 3>>& origins() const { return origins_; }

  /// Adds a point, cluster or piece. Points must be distinct.
  PointId add_point(const LatticePoint& point);
  ClusterId add_cluster(const Plane& plane, double area);
  PieceId add_piece(const Piece& piece);
  /// Gives a piece that was left as it is its plane.
  void place_piece(PieceId id, ClusterId cluster, bool along);
  /// Counts the triangles outside of the complex that have the point: while there are any, it is there to be used.
  void hold(PointId id) { ++holds_[id]; }
  void release(PointId id) { --holds_[id]; }

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
  /// Whether something uses the point, in the complex or outside of it, or it is so new that it will be used.
  [[nodiscard]] bool present(PointId id) const { return live(id) || holds_[id] > 0 || id >= first_unsettled_; }
  [[nodiscard]] bool in_cluster(PointId id, ClusterId cluster) const;
  /// The other ends of its edges.
  [[nodiscard]] std::span<const PointId> neighbours(PointId id) const {
    return {neighbours_[id].data(), neighbours_[id].size()};
  }
  [[nodiscard]] double length(EdgeKey edge) const;
  [[nodiscard]] double distance(PointId a, PointId b) const;
  /// Whether `a` comes before `b` in space; ids are not looked at.
  [[nodiscard]] bool precedes(PointId a, PointId b) const { return points_[a] < points_[b]; }
  [[nodiscard]] const ComplexCounts& counts() const { return counts_; }

  /// Adds a piece to an edge or takes it off; adds an imprint where it is not there yet.
  void toggle(EdgeKey edge, Item item);
  /// Makes edge (u,v) the two edges (u,w), (w,v). False where there is nothing to split, or it is refused.
  bool split(EdgeKey edge, PointId at, Need need = Need::Optional);
  /// Whether both halves would be shorter than the edge. Splitting only then is what makes the loops end.
  [[nodiscard]] bool split_shortens(EdgeKey edge, PointId at) const;
  /// Lets `to` take the place of `from` everywhere. False where it is refused.
  bool merge(PointId from, PointId to, Need need = Need::Optional);
  /// Merges two points into the one whose place draws the surfaces of the other less far from where they were; of equal
  /// ones into the one that precedes. Where that is refused into the other.
  bool merge_either(PointId a, PointId b, Need need = Need::Optional);
  /// Whether the point is near enough to the cluster's plane to be imprinted there.
  [[nodiscard]] bool may_imprint(ClusterId cluster, PointId id) const;
  /// Makes the point a point of the cluster; false where it was one, or it is refused.
  bool imprint_point(ClusterId cluster, PointId id, Need need = Need::Optional);
  /// Takes an imprinted point out that carries no edge of the cluster.
  void drop_point(ClusterId cluster, PointId id);

  /// Every edge when it came to be, in that order, and every point when it came to life: who remembers how many there
  /// were knows what is new. An edge or point that went and came back is there twice.
  [[nodiscard]] std::span<const EdgeKey> edges_added() const { return edges_added_; }
  [[nodiscard]] std::span<const PointId> points_revived() const { return points_revived_; }
  /// Every edge that was split, with the point, and every point that another took the place of, with that, in order.
  [[nodiscard]] std::span<const std::pair<EdgeKey, PointId>> splits_made() const { return splits_made_; }
  [[nodiscard]] std::span<const std::array<PointId, 2>> merges_made() const { return merges_made_; }
  /// Brings the searches below up to date, and forgets new points that were not used.
  void refresh_search();
  /// Calls visit(edge) for every edge whose box meets `box`; for some twice.
  template <typename Visit>
  void for_each_edge_meeting(const geom::LatticeBox& box, Visit&& visit) const {
    edge_tree_.for_each_meeting(box, [&](std::uint32_t at) {
      if (edges_.contains(edges_added_[at])) visit(edges_added_[at]);
    });
  }
  /// Calls visit(point) for every live point that the segment comes within `reach` of, and for some others; for some
  /// twice.
  template <typename Visit>
  void for_each_point_near_segment(const dvec3& from, const dvec3& to, double reach, Visit&& visit) const {
    point_tree_.for_each_near_segment(from, to, reach, [&](std::uint32_t at) {
      if (live(points_revived_[at])) visit(points_revived_[at]);
    });
  }

  /// The point in use nearest to `place` within `reach`, or a new one at the lattice point nearest to it. Where a point
  /// was merged it is what took its place, if there is a reach.
  PointId point_at(const dvec3& place, double reach);
  /// Calls visit(point) for all points in use within `reach` of the place, and some more.
  template <typename Visit>
  void for_each_point_near(const dvec3& place, double reach, Visit&& visit) const {
    grid_.for_each_near(place, reach, [&](PointId id) {
      if (present(id)) visit(id);
    });
  }

 private:
  void touch(Item item) { ++clusters_[cluster_of(item)].version; }
  void link(EdgeKey edge);
  void unlink(EdgeKey edge);
  [[nodiscard]] PointId nearest(const dvec3& place, double reach) const;
  [[nodiscard]] PointId became(PointId id) const;
  [[nodiscard]] PointId became_of_merged(const dvec3& place) const;
  [[nodiscard]] bool draws_off(std::span<const Item> items, PointId to) const;
  /// How far the point is from where the surface of the item was.
  [[nodiscard]] double drawn(Item item, PointId to) const;
  [[nodiscard]] double drawn_by_merge(PointId from, PointId to) const;
  [[nodiscard]] bool is_off_plane(ClusterId cluster, PointId id) const;
  [[nodiscard]] bool is_held(std::uint32_t origin) const;

  void note_revival(PointId id);

  using Items = boost::container::small_vector<Item, 4>;

  double tolerance_;
  std::vector<LatticePoint> points_;
  std::vector<Cluster> clusters_;
  std::vector<Piece> pieces_;
  tsl::robin_map<EdgeKey, Items, EdgeKeyHash> edges_;
  std::vector<boost::container::small_vector<PointId, 6>> neighbours_;      ///< per point
  std::vector<boost::container::small_vector<ClusterId, 2>> imprinted_in_;  ///< per point
  std::vector<std::uint32_t> holds_;                                        ///< per point
  PointGrid grid_;                                                          ///< of all points
  std::vector<EdgeKey> edges_added_;
  std::vector<PointId> points_revived_;
  std::vector<std::pair<EdgeKey, PointId>> splits_made_;
  std::vector<std::array<PointId, 2>> merges_made_;
  tsl::robin_map<PointId, PointId> merged_into_;  ///< per point that another took the place of: that
  geom::GrowingBoxTree edge_tree_;                ///< items are places in edges_added_
  geom::GrowingBoxTree point_tree_;               ///< items are places in points_revived_
  std::size_t edges_searched_ = 0;                ///< of edges_added_: in the tree
  std::size_t points_searched_ = 0;
  PointId first_unsettled_ = 0;  ///< points from here on are new
  std::vector<std::array<LatticePoint, 3>> origins_;
  double farthest_ = std::numeric_limits<double>::infinity();
  std::vector<std::uint8_t> held_;  ///< per origin; empty where all are
  ComplexCounts counts_;
};

}  // namespace rad::repair
