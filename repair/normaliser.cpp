#include "repair/normaliser.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace rad::repair {
namespace {

// Never reached in the plane; between planes a pair of points may be inserted again and again.
constexpr int kPassCap = 200;
constexpr std::int32_t kBeyondLattice = 1 << 25;

using geom::orient2d;
using geom::PlanarPoint;
using geom::Sign;

PointId nearer_end(const Complex& complex, EdgeKey edge, PointId point) {
  const auto [a, b] = ends_of(edge);
  return complex.distance(a, point) < complex.distance(b, point) ? a : b;
}

// Where the segment ab is cut by the line through c and d, as a share of its way.
double cut_share(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) {
  const auto twice_area = [&](const PlanarPoint& p) {
    return std::abs(static_cast<double>((d.u - c.u) * (p.v - c.v) - (d.v - c.v) * (p.u - c.u)));
  };
  const double at_a = twice_area(a), at_b = twice_area(b);
  return at_a + at_b > 0 ? at_a / (at_a + at_b) : 0.5;
}

}  // namespace

void split_or_merge(Complex& complex, EdgeKey edge, PointId point) {
  if (complex.split_shortens(edge, point)) {
    complex.split(edge, point);
  } else {
    complex.merge_either(point, nearer_end(complex, edge, point));
  }
}

namespace {

struct Insertion {
  EdgeKey edge = 0;
  PointId point = 0;
};

// What goes into one edge: into the edge itself first, then into its parts.
struct EdgeInsertions {
  std::size_t edge = 0;  ///< index among those searched
  std::vector<Insertion> list;
};

// The live point nearest to an edge within T that does not end it. Of equally near points the one nearest to the
// middle: so a row of points is halved, not taken off one by one.
PointId nearest_point_on(const Complex& complex, EdgeKey edge) {
  const auto [a, b] = ends_of(edge);
  const dvec3 from = complex.place(a), to = complex.place(b), middle = 0.5 * (from + to);
  PointId best = scene::kNoPoint;
  std::pair<double, double> best_distance;
  complex.for_each_point_near_segment(from, to, complex.tolerance(), [&](PointId id) {
    if (id == a || id == b || id == best) return;
    const dvec3 place = complex.place(id);
    const std::pair away(geom::distance_to_segment(place, from, to), glm::distance(place, middle));
    if (away.first > complex.tolerance()) return;
    const bool nearer = best == scene::kNoPoint || away < best_distance;
    if (!nearer && (away != best_distance || complex.precedes(best, id))) return;
    best = id;
    best_distance = away;
  });
  return best;
}

// Only the parts of an edge that a split makes shorter are looked at in their turn.
std::vector<Insertion> points_in(const Complex& complex, EdgeKey edge) {
  std::vector<Insertion> found;
  std::vector<EdgeKey> open{edge};
  while (!open.empty()) {
    const EdgeKey part = open.back();
    open.pop_back();
    const PointId point = nearest_point_on(complex, part);
    if (point == scene::kNoPoint) continue;
    found.push_back({part, point});
    if (!complex.split_shortens(part, point)) continue;
    for (const PointId end : ends_of(part)) open.push_back(edge_key(end, point));
  }
  return found;
}

std::vector<EdgeInsertions> points_on_edges(const Complex& complex, std::span<const EdgeKey> edges) {
  tbb::enumerable_thread_specific<std::vector<EdgeInsertions>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      std::vector<Insertion> list = points_in(complex, edges[i]);
      if (!list.empty()) found.local().push_back({i, std::move(list)});
    }
  });
  std::vector<EdgeInsertions> all;
  for (auto& part : found) std::ranges::move(part, std::back_inserter(all));
  std::ranges::sort(all, {}, &EdgeInsertions::edge);
  return all;
}

}  // namespace

// The edges that are new, and those that a new point is near; ascending.
std::vector<EdgeKey> Normaliser::edges_to_search() {
  complex_.refresh_search();
  std::vector<EdgeKey> edges = std::exchange(put_off_, {});
  const auto added = complex_.edges_added();
  edges.insert(edges.end(), added.begin() + static_cast<std::ptrdiff_t>(edges_seen_), added.end());
  const auto inflation = static_cast<std::int32_t>(std::ceil(complex_.tolerance()));
  const auto revived = complex_.points_revived();
  if (edges_seen_ == 0) points_seen_ = revived.size();  // every edge is searched anyway
  for (; points_seen_ < revived.size(); ++points_seen_) {
    const PointId id = revived[points_seen_];
    if (!complex_.live(id)) continue;
    complex_.for_each_edge_meeting(geom::box_of(std::span(&complex_.point(id), 1), inflation), [&](EdgeKey edge) {
      const auto [a, b] = ends_of(edge);
      if (a == id || b == id) return;
      const double away = geom::distance_to_segment(complex_.place(id), complex_.place(a), complex_.place(b));
      if (away <= complex_.tolerance()) edges.push_back(edge);
    });
  }
  edges_seen_ = added.size();
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::erase_if(edges, [&](EdgeKey edge) { return !complex_.has_edge(edge); });
  return edges;
}

bool Normaliser::insert_points_on_edges() {
  bool changed = false;
  for (int pass = 0; pass < kPassCap; ++pass) {
    const std::vector<EdgeInsertions> found = points_on_edges(complex_, edges_to_search());
    if (found.empty()) break;
    changed = true;
    bool merged = false;  // one merge a pass: the next may be of what is no longer there
    for (const EdgeInsertions& insertions : found) {
      for (const auto& [edge, point] : insertions.list) {
        if (!complex_.live(point)) {  // merged in this pass: a split would bring it back
          put_off_.push_back(edge);
        } else if (complex_.split_shortens(edge, point)) {
          complex_.split(edge, point);
        } else if (merged) {
          put_off_.push_back(edge);
        } else if (complex_.has_edge(edge)) {
          merged = complex_.merge_either(point, nearer_end(complex_, edge, point));
        }
      }
    }
  }
  return changed;
}

namespace {

geom::LatticeBox flat_box(const Complex& complex, const Plane& plane, EdgeKey edge) {
  const auto [a, b] = ends_of(edge);
  geom::LatticeBox box = geom::box_of(std::array{complex.point(a), complex.point(b)});
  const auto axis = static_cast<std::size_t>(plane.axis);
  box.low[axis] = -kBeyondLattice;
  box.high[axis] = kBeyondLattice;
  return box;
}

// Whether two edges without a common end cross or touch in projection; those of one line do not.
bool may_cross(const Complex& complex, const Plane& plane, EdgeKey e, EdgeKey f) {
  const auto [a, b] = ends_of(e);
  const auto [c, d] = ends_of(f);
  if (a == c || a == d || b == c || b == d) return false;
  const PlanarPoint p = plane.project(complex.point(a)), q = plane.project(complex.point(b));
  const PlanarPoint r = plane.project(complex.point(c)), s = plane.project(complex.point(d));
  const int pqr = static_cast<int>(orient2d(p, q, r)), pqs = static_cast<int>(orient2d(p, q, s));
  if (pqr == 0 && pqs == 0) return false;  // points go into edges elsewhere
  const int rsp = static_cast<int>(orient2d(r, s, p)), rsq = static_cast<int>(orient2d(r, s, q));
  return pqr * pqs <= 0 && rsp * rsq <= 0;
}

// Cuts crossings of one cluster's edges in projection.
class CrossingCutter {
 public:
  CrossingCutter(Complex& complex, const Plane& plane, double reach)
      : complex_(complex), plane_(plane), reach_(reach) {}

  // Cuts each crossing of two edges, or of the parts that they have become; up to the first that needs a merge.
  // `pairs` ascending.
  bool run(std::span<const std::array<EdgeKey, 2>> pairs) {
    bool changed = false;
    for (const auto& [first, second] : pairs) {
      changed |= cut_pair(first, second);
      if (merge_ && complex_.merge_either((*merge_)[0], (*merge_)[1], Need::Sound)) break;
      merge_.reset();  // refused
    }
    return changed;
  }
  // Whether a merge ended the last run before the last pair.
  [[nodiscard]] bool stopped() const { return merge_.has_value(); }

 private:
  // The points that an edge was cut at, by their share of its way.
  using Cuts = std::map<double, PointId>;

  // What is now where the edge was at this share of its way.
  [[nodiscard]] EdgeKey part_at(EdgeKey edge, double share) const {
    const auto found = cuts_.find(edge);
    if (found == cuts_.end()) return edge;
    const auto [a, b] = ends_of(edge);
    const Cuts& cuts = found->second;
    const auto after = cuts.upper_bound(share);
    const PointId from = after == cuts.begin() ? a : std::prev(after)->second;
    return edge_key(from, after == cuts.end() ? b : after->second);
  }

  bool cut_pair(EdgeKey first, EdgeKey second) {
    const auto [p, q] = flat(first);
    const auto [r, s] = flat(second);
    const double first_share = cut_share(p, q, r, s), second_share = cut_share(r, s, p, q);
    const EdgeKey e = part_at(first, first_share), f = part_at(second, second_share);
    if (e == f || !crosses(e, f)) return false;
    const PointId point = complex_.point_at(place_of_crossing(e, f), reach_);
    const bool e_split = cut(e, point), f_split = cut(f, point);
    if (e_split) cuts_[first].emplace(first_share, point);
    if (f_split) cuts_[second].emplace(second_share, point);
    if (is_end(e, point) && is_end(f, point) && !merge_) merge_ = nearest_ends(e, f);
    return true;
  }

  [[nodiscard]] std::array<PlanarPoint, 2> flat(EdgeKey edge) const {
    const auto [a, b] = ends_of(edge);
    return {plane_.project(complex_.point(a)), plane_.project(complex_.point(b))};
  }

  [[nodiscard]] bool crosses(EdgeKey e, EdgeKey f) const {
    return complex_.has_edge(e) && complex_.has_edge(f) && may_cross(complex_, plane_, e, f);
  }

  // The edges cross in projection; in space a gap may remain between them. Where it is within T the point goes onto the
  // longer edge, otherwise into the middle, so that stacked edges draw together.
  [[nodiscard]] dvec3 place_of_crossing(EdgeKey e, EdgeKey f) const {
    const auto [a, b] = ends_of(e);
    const auto [c, d] = ends_of(f);
    const auto [p, q] = flat(e);
    const auto [r, s] = flat(f);
    const dvec3 on_e = complex_.place(a) + cut_share(p, q, r, s) * (complex_.place(b) - complex_.place(a));
    const dvec3 on_f = complex_.place(c) + cut_share(r, s, p, q) * (complex_.place(d) - complex_.place(c));
    if (glm::distance(on_e, on_f) > complex_.tolerance()) return 0.5 * (on_e + on_f);
    return complex_.length(e) > complex_.length(f) ? on_e : on_f;
  }

  static bool is_end(EdgeKey edge, PointId point) {
    const auto [a, b] = ends_of(edge);
    return point == a || point == b;
  }

  // True where the edge was split.
  bool cut(EdgeKey edge, PointId point) {
    if (is_end(edge, point)) return false;
    if (complex_.split_shortens(edge, point)) return complex_.split(edge, point, Need::Sound);
    merge_ = {point, nearer_end(complex_, edge, point)};
    return false;
  }

  // Both end at the same point of space and still cross: stacked.
  [[nodiscard]] std::array<PointId, 2> nearest_ends(EdgeKey e, EdgeKey f) const {
    std::array<PointId, 2> best{};
    double best_distance = -1;
    for (const PointId u : ends_of(e)) {
      for (const PointId v : ends_of(f)) {
        const double away = complex_.distance(u, v);
        if (u == v || (best_distance >= 0 && away >= best_distance)) continue;
        best_distance = away;
        best = {u, v};
      }
    }
    return best;
  }

  Complex& complex_;
  const Plane plane_;
  double reach_;
  tsl::robin_map<EdgeKey, Cuts, EdgeKeyHash> cuts_;
  std::optional<std::array<PointId, 2>> merge_;
};

}  // namespace

// Pairs of a cluster's edges that may cross and of which one is new, ascending. The new ones are in the tree
// afterwards.
std::vector<std::array<EdgeKey, 2>> Normaliser::new_crossings(ClusterId cluster) {
  const Cluster& own = complex_.clusters()[cluster];
  FlatEdges& flat = flat_[cluster];
  const auto is_own = [&](std::uint32_t at) { return own.edges.contains(own.added[at]); };
  std::vector<geom::LatticeBox> boxes;
  std::vector<std::uint32_t> items;
  for (std::size_t at = flat.uncrossed; at < own.added.size(); ++at) {
    if (!is_own(static_cast<std::uint32_t>(at))) continue;
    boxes.push_back(flat_box(complex_, own.plane, own.added[at]));
    items.push_back(static_cast<std::uint32_t>(at));
  }
  std::vector<std::array<EdgeKey, 2>> pairs;
  const auto consider = [&](EdgeKey edge, EdgeKey other) {
    if (edge == other || !may_cross(complex_, own.plane, edge, other)) return;
    pairs.push_back({std::min(edge, other), std::max(edge, other)});
  };
  geom::BoxTree tree(boxes);
  const auto count = static_cast<std::uint32_t>(items.size());
  tree.for_each_later_meeting(
      0, count, [&](std::uint32_t x, std::uint32_t y) { consider(own.added[items[x]], own.added[items[y]]); });
  tree.for_each_leaf(0, count, [&](const geom::LatticeBox& box, std::uint32_t first, std::uint32_t last) {
    flat.tree.for_each_meeting(box, [&](std::uint32_t other) {
      if (other >= flat.uncrossed || !is_own(other)) return;
      const geom::LatticeBox others = flat_box(complex_, own.plane, own.added[other]);
      for (std::uint32_t slot = first; slot != last; ++slot) {
        const std::uint32_t item = tree.order()[slot];
        if (boxes[item].meets(others)) consider(own.added[items[item]], own.added[other]);
      }
    });
  });
  if (flat.searched == flat.uncrossed) {
    flat.tree.add(std::move(boxes), std::move(items), std::move(tree), is_own);
  } else {
    const auto known = std::ranges::lower_bound(items, flat.searched) - items.begin();
    boxes.erase(boxes.begin(), boxes.begin() + known);
    items.erase(items.begin(), items.begin() + known);
    flat.tree.add(std::move(boxes), std::move(items), is_own);
  }
  flat.searched = own.added.size();
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool Normaliser::cut_crossings_in(ClusterId cluster, double reach) {
  const Cluster& own = complex_.clusters()[cluster];
  FlatEdges& flat = flat_[cluster];
  if (flat.uncrossed == own.added.size()) return false;
  const std::vector<std::array<EdgeKey, 2>> pairs = new_crossings(cluster);
  const std::size_t looked_at = own.added.size();
  CrossingCutter cutter(complex_, own.plane, reach);
  const bool changed = cutter.run(pairs);
  if (!cutter.stopped()) flat.uncrossed = looked_at;
  return changed;
}

bool Normaliser::cut_crossings(double reach) {
  flat_.resize(complex_.clusters().size());
  bool changed = false;
  for (ClusterId id = 0; id < complex_.clusters().size(); ++id) changed |= cut_crossings_in(id, reach);
  return changed;
}

bool Normaliser::run(double reach) {
  bool any = false;
  for (int round = 0; round < kPassCap; ++round) {
    const bool inserted = insert_points_on_edges();
    const bool cut = cut_crossings(reach);
    any = any || inserted || cut;
    if (!cut) break;
  }
  return any;
}

}  // namespace rad::repair
