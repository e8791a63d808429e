#include "repair/isect.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>

#include "repair/distance.h"
#include "repair/triangle_search.h"

namespace rad::repair {
namespace {

// A contact edge is looked at in this many places for whether it runs over the other region.
constexpr int kContactSamples = 16;

}  // namespace

struct Isect::Pass {
  Isect& isect;
  Complex& complex;
  const Triangulation& triangulation;
  const TriangleSearch& search;
  double tolerance = complex.tolerance();
  double band = kOnPlaneShare * tolerance;
  bool changed = false;
  std::set<ClusterPair> touched;  ///< pairs with new events
  std::vector<std::pair<EdgeKey, PointId>> splits;

  Pass(Isect& owner, const Triangulation& triangles)
      : isect(owner), complex(owner.complex_), triangulation(triangles), search(owner.search_) {}

  [[nodiscard]] const Plane& plane(ClusterId id) const { return complex.clusters()[id].plane; }

  // Clusters of the pieces on an edge, ascending; imprints do not count.
  [[nodiscard]] std::vector<ClusterId> owners(EdgeKey edge) const {
    std::vector<ClusterId> list;
    for (const Item item : complex.items(edge)) {
      if (item.is_piece()) list.push_back(complex.cluster_of(item));
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  void add_event(std::span<const ClusterId> own, ClusterId cluster, PointId point) {
    for (const ClusterId other : own) {
      const ClusterPair pair{std::min(other, cluster), std::max(other, cluster)};
      if (isect.events_[pair].insert(point).second) touched.insert(pair);
    }
  }

  void imprint_point(ClusterId cluster, PointId point) { changed |= complex.imprint_point(cluster, point); }

  // A point that lies on the plane and on the triangle is a point of the triangle's cluster.
  void point_on_plane(std::span<const ClusterId> own, const Triangle& triangle, PointId point) {
    const bool on_triangle = search.distance(complex.place(point), triangle) <= tolerance;
    if (on_triangle) imprint_point(triangle.cluster, point);
    if (on_triangle || complex.clusters()[triangle.cluster].points.contains(point)) {
      add_event(own, triangle.cluster, point);
    }
  }

  void cross(EdgeKey edge, std::span<const ClusterId> own, const Triangle& triangle, std::set<ClusterId>& split_by) {
    const auto [a, b] = ends_of(edge);
    const dvec3 from = complex.place(a), to = complex.place(b);
    const double at_from = plane(triangle.cluster).height(from), at_to = plane(triangle.cluster).height(to);
    const bool from_on = std::abs(at_from) <= band, to_on = std::abs(at_to) <= band;
    if (from_on) point_on_plane(own, triangle, a);
    if (to_on) point_on_plane(own, triangle, b);
    if (from_on || to_on || (at_from > 0) == (at_to > 0)) return;
    const dvec3 place = from + at_from / (at_from - at_to) * (to - from);
    if (search.distance(place, triangle) > band) return;
    const auto [entry, is_new] = isect.crossing_.try_emplace({edge, triangle.cluster}, 0);
    if (is_new) entry->second = complex.point_at(place, complex.weld_distance());
    const PointId point = entry->second;
    if (split_by.insert(triangle.cluster).second) splits.push_back({edge, point});
    complex.imprint_point(triangle.cluster, point);
    add_event(own, triangle.cluster, point);
  }

  // Both ends lie on the plane: the edge itself is the contact.
  void imprint_contact(EdgeKey edge, std::span<const ClusterId> own, ClusterId cluster) {
    const auto [a, b] = ends_of(edge);
    const dvec3 from = complex.place(a), to = complex.place(b);
    if (std::ranges::binary_search(own, cluster)) return;
    if (std::abs(plane(cluster).height(from)) > band || std::abs(plane(cluster).height(to)) > band) return;
    if (std::ranges::find(complex.items(edge), Item::imprint(cluster)) != complex.items(edge).end()) return;
    bool over = false;
    for (int i = 1; i < kContactSamples && !over; ++i) {
      over = search.in_region(cluster, from + (static_cast<double>(i) / kContactSamples) * (to - from), band);
    }
    if (!over || !isect.contacts_.insert({edge, cluster}).second) return;
    imprint_edge(edge, cluster);
  }

  void imprint_edge(EdgeKey edge, ClusterId cluster) {
    complex.toggle(edge, Item::imprint(cluster));
    for (const PointId point : ends_of(edge)) complex.imprint_point(cluster, point);
    changed = true;
  }

  [[nodiscard]] std::vector<std::uint32_t> triangles_near(EdgeKey edge) const {
    const auto [a, b] = ends_of(edge);
    return search.near_segment(complex.place(a), complex.place(b), tolerance);
  }

  void look_at(EdgeKey edge, std::span<const std::uint32_t> found) {
    const std::vector<ClusterId> own = owners(edge);
    if (own.empty()) return;
    std::set<ClusterId> split_by, near;
    for (const std::uint32_t i : found) {
      const Triangle& triangle = triangulation.triangles()[i];
      if (std::ranges::binary_search(own, triangle.cluster)) continue;
      cross(edge, own, triangle, split_by);
      near.insert(triangle.cluster);
    }
    for (const ClusterId cluster : near) imprint_contact(edge, own, cluster);
  }

  // The points on both planes in the order of their common line.
  [[nodiscard]] std::vector<PointId> ordered(const ClusterPair& pair, const std::set<PointId>& points) const {
    const dvec3 line = glm::cross(plane(pair[0]).normal, plane(pair[1]).normal);
    constexpr double kLeastSine = 1e-9;  // below it the planes have no line that double numbers could tell
    if (points.size() < 2 || glm::length(line) < kLeastSine) return {};
    std::vector<PointId> list;
    std::ranges::copy_if(points, std::back_inserter(list), [&](PointId id) { return complex.live(id); });
    std::sort(list.begin(), list.end(), [&](PointId u, PointId v) {
      const double difference = glm::dot(complex.place(u) - complex.place(v), line);
      return difference != 0 ? difference < 0 : complex.precedes(u, v);
    });
    return list;
  }

  void imprint_chords(const ClusterPair& pair, const std::set<PointId>& points) {
    const std::vector<PointId> line = ordered(pair, points);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const dvec3 middle = 0.5 * (complex.place(line[i]) + complex.place(line[i + 1]));
      const bool in_both = std::ranges::all_of(pair, [&](ClusterId cluster) {
        return std::abs(plane(cluster).height(middle)) <= tolerance && search.in_region(cluster, middle, tolerance / 2);
      });
      const EdgeKey edge = edge_key(line[i], line[i + 1]);
      if (!in_both || !isect.chords_.insert({pair, edge}).second) continue;
      for (const ClusterId cluster : pair) {
        if (!complex.edge_in_cluster(edge, cluster)) imprint_edge(edge, cluster);
      }
    }
  }
};

// The edges that are new, and those that new triangles are near; ascending.
std::vector<EdgeKey> Isect::edges_to_look_at(const Triangulation& triangulation) {
  complex_.refresh_search();
  const std::uint32_t first_new = search_.first_new();
  search_.update(triangulation);
  const auto added = complex_.edges_added();
  std::vector<EdgeKey> edges(added.begin() + static_cast<std::ptrdiff_t>(edges_seen_), added.end());
  edges_seen_ = added.size();
  const auto inflation = static_cast<std::int32_t>(std::ceil(complex_.tolerance()));
  const auto triangles = triangulation.triangles();
  for (std::uint32_t i = first_new; i < triangles.size(); ++i) {
    if (triangles[i].cluster == kNoCluster || !triangulation.alive()[i]) continue;
    complex_.for_each_edge_meeting(search_.box(triangles[i], inflation), [&](EdgeKey edge) { edges.push_back(edge); });
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::erase_if(edges, [&](EdgeKey edge) { return !complex_.has_edge(edge); });
  return edges;
}

bool Isect::pass(const Triangulation& triangulation) {
  const std::vector<EdgeKey> edges = edges_to_look_at(triangulation);
  Pass pass(*this, triangulation);
  std::vector<std::vector<std::uint32_t>> near(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) { near[i] = pass.triangles_near(edges[i]); });
  for (std::size_t i = 0; i < edges.size(); ++i) pass.look_at(edges[i], near[i]);
  for (const ClusterPair& pair : pass.touched) pass.imprint_chords(pair, events_.at(pair));
  for (const auto& [edge, point] : pass.splits) pass.changed |= complex_.split(edge, point);
  return pass.changed;
}

}  // namespace rad::repair
