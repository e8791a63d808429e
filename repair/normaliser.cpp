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

#include "geom/box_tree.h"

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
    complex.merge_into_first(point, nearer_end(complex, edge, point));
  }
}

namespace {

struct Insertion {
  EdgeKey edge = 0;
  PointId point = 0;
};

// What goes into one edge: into the edge itself first, then into its parts.
struct EdgeInsertions {
  std::size_t edge = 0;  ///< index among all edges
  std::vector<Insertion> list;
};

// Finds the live points within T of edges that they do not end.
class PointFinder {
 public:
  explicit PointFinder(const Complex& complex) : complex_(complex), live_(live_points(complex)), tree_(places()) {}

  // Only the parts of an edge that a split makes shorter are looked at in their turn.
  [[nodiscard]] std::vector<Insertion> in_edge(EdgeKey edge) const {
    std::vector<Insertion> found;
    std::vector<EdgeKey> open{edge};
    while (!open.empty()) {
      const EdgeKey part = open.back();
      open.pop_back();
      const PointId point = nearest(part);
      if (point == scene::kNoPoint) continue;
      found.push_back({part, point});
      if (!complex_.split_shortens(part, point)) continue;
      for (const PointId end : ends_of(part)) open.push_back(edge_key(end, point));
    }
    return found;
  }

 private:
  static std::vector<PointId> live_points(const Complex& complex) {
    std::vector<PointId> live;
    for (PointId id = 0; id < complex.point_count(); ++id) {
      if (complex.live(id)) live.push_back(id);
    }
    return live;
  }
  [[nodiscard]] std::vector<geom::LatticeBox> places() const {
    std::vector<geom::LatticeBox> boxes;
    boxes.reserve(live_.size());
    for (const PointId id : live_) boxes.push_back(geom::box_of(std::span(&complex_.point(id), 1)));
    return boxes;
  }

  // Of equally near points the one nearest to the middle: so a row of points is halved, not taken off one by one.
  [[nodiscard]] PointId nearest(EdgeKey edge) const {
    const auto [a, b] = ends_of(edge);
    const dvec3 from = complex_.place(a), to = complex_.place(b), middle = 0.5 * (from + to);
    PointId best = scene::kNoPoint;
    std::pair<double, double> best_distance;
    tree_.for_each_near_segment(from, to, complex_.tolerance(), [&](std::uint32_t at) {
      const PointId id = live_[at];
      if (id == a || id == b) return;
      const dvec3 place = complex_.place(id);
      const std::pair away(geom::distance_to_segment(place, from, to), glm::distance(place, middle));
      if (away.first > complex_.tolerance()) return;
      const bool nearer = best == scene::kNoPoint || away < best_distance;
      if (!nearer && (away != best_distance || complex_.precedes(best, id))) return;
      best = id;
      best_distance = away;
    });
    return best;
  }

  const Complex& complex_;
  std::vector<PointId> live_;
  geom::BoxTree tree_;
};

std::vector<EdgeInsertions> points_on_edges(const Complex& complex) {
  const PointFinder finder(complex);
  const std::vector<EdgeKey> edges = complex.edges();
  tbb::enumerable_thread_specific<std::vector<EdgeInsertions>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      std::vector<Insertion> list = finder.in_edge(edges[i]);
      if (!list.empty()) found.local().push_back({i, std::move(list)});
    }
  });
  std::vector<EdgeInsertions> all;
  for (auto& part : found) std::ranges::move(part, std::back_inserter(all));
  std::ranges::sort(all, {}, &EdgeInsertions::edge);
  return all;
}

}  // namespace

bool Normaliser::insert_points_on_edges() {
  bool changed = false;
  for (int pass = 0; pass < kPassCap; ++pass) {
    const std::vector<EdgeInsertions> found = points_on_edges(complex_);
    if (found.empty()) break;
    changed = true;
    bool merged = false;  // one merge a pass: the next may be of what is no longer there
    for (const EdgeInsertions& insertions : found) {
      for (const auto& [edge, point] : insertions.list) {
        if (!complex_.live(point)) continue;  // merged in this pass: a split would bring it back
        if (complex_.split_shortens(edge, point)) {
          complex_.split(edge, point);
        } else if (!merged && complex_.has_edge(edge)) {
          complex_.merge_into_first(point, nearer_end(complex_, edge, point));
          merged = true;
        }
      }
    }
  }
  return changed;
}

namespace {

// Finds and cuts the crossings of one cluster's edges in projection.
class CrossingCutter {
 public:
  CrossingCutter(Complex& complex, ClusterId cluster, double reach)
      : complex_(complex),
        plane_(complex.clusters()[cluster].plane),
        reach_(reach),
        edges_(complex.clusters()[cluster].edges.begin(), complex.clusters()[cluster].edges.end()),
        cuts_(edges_.size()) {}

  // Cuts each crossing of two edges, or of the parts that they have become; up to the first that needs a merge.
  bool run() {
    std::vector<geom::LatticeBox> boxes;
    boxes.reserve(edges_.size());
    for (const EdgeKey edge : edges_) boxes.push_back(flat_box(edge));
    const geom::BoxTree tree(boxes);
    bool changed = false;
    for (std::size_t i = 0; i < edges_.size() && !merge_; ++i) {
      std::vector<std::uint32_t> others;
      tree.for_each_meeting(boxes[i], [&](std::uint32_t j) {
        if (j > i) others.push_back(j);
      });
      std::sort(others.begin(), others.end());
      for (const std::uint32_t j : others) {
        if (merge_) break;
        changed |= cut_pair(static_cast<std::uint32_t>(i), j);
      }
    }
    if (merge_) complex_.merge_into_first((*merge_)[0], (*merge_)[1]);
    return changed;
  }

 private:
  // The points that an edge was cut at, by their share of its way.
  using Cuts = std::map<double, PointId>;

  // What is now where the edge was at this share of its way.
  [[nodiscard]] EdgeKey part_at(std::uint32_t i, double share) const {
    const auto [a, b] = ends_of(edges_[i]);
    const auto after = cuts_[i].upper_bound(share);
    const PointId from = after == cuts_[i].begin() ? a : std::prev(after)->second;
    return edge_key(from, after == cuts_[i].end() ? b : after->second);
  }

  bool cut_pair(std::uint32_t i, std::uint32_t j) {
    const auto [p, q] = flat(edges_[i]);
    const auto [r, s] = flat(edges_[j]);
    const double i_share = cut_share(p, q, r, s), j_share = cut_share(r, s, p, q);
    const EdgeKey e = part_at(i, i_share), f = part_at(j, j_share);
    if (e == f || !crosses(e, f)) return false;
    const PointId point = complex_.point_at(place_of_crossing(e, f), reach_);
    const bool e_split = cut(e, point), f_split = cut(f, point);
    if (e_split) cuts_[i].emplace(i_share, point);
    if (f_split) cuts_[j].emplace(j_share, point);
    if (!e_split && !f_split && !merge_) merge_ = nearest_ends(e, f);
    return true;
  }

  [[nodiscard]] geom::LatticeBox flat_box(EdgeKey edge) const {
    const auto [a, b] = ends_of(edge);
    const std::array ends{complex_.point(a), complex_.point(b)};
    geom::LatticeBox box = geom::box_of(ends);
    const auto axis = static_cast<std::size_t>(plane_.axis);
    box.low[axis] = -kBeyondLattice;
    box.high[axis] = kBeyondLattice;
    return box;
  }

  [[nodiscard]] std::array<PlanarPoint, 2> flat(EdgeKey edge) const {
    const auto [a, b] = ends_of(edge);
    return {plane_.project(complex_.point(a)), plane_.project(complex_.point(b))};
  }

  [[nodiscard]] bool crosses(EdgeKey e, EdgeKey f) const {
    const auto [a, b] = ends_of(e);
    const auto [c, d] = ends_of(f);
    if (a == c || a == d || b == c || b == d || !complex_.has_edge(e) || !complex_.has_edge(f)) return false;
    const auto [p, q] = flat(e);
    const auto [r, s] = flat(f);
    const int pqr = static_cast<int>(orient2d(p, q, r)), pqs = static_cast<int>(orient2d(p, q, s));
    if (pqr == 0 && pqs == 0) return false;  // on one line: points go into edges elsewhere
    const int rsp = static_cast<int>(orient2d(r, s, p)), rsq = static_cast<int>(orient2d(r, s, q));
    return pqr * pqs <= 0 && rsp * rsq <= 0;
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

  // True where the edge was split.
  bool cut(EdgeKey edge, PointId point) {
    const auto [a, b] = ends_of(edge);
    if (point == a || point == b) return false;
    if (complex_.split_shortens(edge, point)) return complex_.split(edge, point);
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
  std::vector<EdgeKey> edges_;
  std::vector<Cuts> cuts_;  ///< per edge
  std::optional<std::array<PointId, 2>> merge_;
};

}  // namespace

bool Normaliser::cut_crossings_in(ClusterId cluster, double reach) {
  if (uncrossed_[cluster] == complex_.clusters()[cluster].version) return false;
  if (CrossingCutter(complex_, cluster, reach).run()) return true;
  uncrossed_[cluster] = complex_.clusters()[cluster].version;
  return false;
}

bool Normaliser::cut_crossings(double reach) {
  complex_.refresh_grid();
  uncrossed_.resize(complex_.clusters().size(), 0);
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
