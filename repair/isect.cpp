#include "repair/isect.h"

#include <tbb/blocked_range.h>
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

// An edge and a triangle of another cluster's that may have a point in common.
struct Meeting {
  ClusterId cluster = 0;
  std::uint32_t triangle = 0;
  bool from_on = false;  ///< this end of the edge lies on the plane
  bool to_on = false;
  bool crosses = false;  ///< the edge goes through the plane at `place`, which is on the triangle
  dvec3 place{0, 0, 0};
};

struct Isect::Pass {
  using Owners = boost::container::small_vector<ClusterId, 4>;

  Isect& isect;
  Complex& complex;
  const Triangulation& triangulation;
  const TriangleSearch& search;
  double tolerance = complex.tolerance();
  double band = kOnPlaneShare * tolerance;
  bool changed = false;
  std::vector<Event> events;
  std::vector<std::pair<EdgeKey, PointId>> splits;

  Pass(Isect& owner, const Triangulation& triangles)
      : isect(owner), complex(owner.complex_), triangulation(triangles), search(owner.search_) {}

  [[nodiscard]] const Plane& plane(ClusterId id) const { return complex.clusters()[id].plane; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t i) const { return triangulation.triangles()[i]; }

  // Clusters of the pieces on an edge, ascending; imprints do not count.
  [[nodiscard]] Owners owners(EdgeKey edge) const {
    Owners list;
    for (const Item item : complex.items(edge)) {
      if (item.is_piece()) list.push_back(complex.cluster_of(item));
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  // What the edge meets, by triangle. Changes nothing, so edges may be searched side by side.
  [[nodiscard]] std::vector<Meeting> meetings_of(EdgeKey edge) const {
    const Owners own = owners(edge);
    std::vector<Meeting> found;
    if (own.empty()) return found;
    const auto [a, b] = ends_of(edge);
    const dvec3 from = complex.place(a), to = complex.place(b);
    search.for_each_near_segment(from, to, tolerance, [&](std::uint32_t i) {
      const ClusterId cluster = triangle(i).cluster;
      if (std::ranges::find(own, cluster) != own.end()) return;
      const double at_from = plane(cluster).height(from), at_to = plane(cluster).height(to);
      Meeting meeting{cluster, i, std::abs(at_from) <= band, std::abs(at_to) <= band, false, {}};
      if (!meeting.from_on && !meeting.to_on) {
        if ((at_from > 0) == (at_to > 0)) return;
        meeting.place = from + at_from / (at_from - at_to) * (to - from);
        meeting.crosses = search.distance(meeting.place, triangle(i)) <= band;
        if (!meeting.crosses) return;
      }
      found.push_back(meeting);
    });
    std::ranges::sort(found, {}, &Meeting::triangle);
    return found;
  }

  void add_event(std::span<const ClusterId> own, ClusterId cluster, PointId point) {
    for (const ClusterId other : own) {
      events.push_back({std::uint64_t{std::min(other, cluster)} << 32 | std::max(other, cluster), point});
    }
  }

  void imprint_point(ClusterId cluster, PointId point) { changed |= complex.imprint_point(cluster, point); }

  // A point that lies on the plane and on the triangle is a point of the triangle's cluster.
  void point_on_plane(std::span<const ClusterId> own, const Triangle& on, PointId point) {
    const bool on_triangle = search.distance(complex.place(point), on) <= tolerance;
    if (on_triangle) imprint_point(on.cluster, point);
    if (on_triangle || complex.clusters()[on.cluster].points.contains(point)) add_event(own, on.cluster, point);
  }

  void cut(EdgeKey edge, std::span<const ClusterId> own, const Meeting& meeting, std::vector<ClusterId>& split_by) {
    const auto [a, b] = ends_of(edge);
    if (meeting.from_on) point_on_plane(own, triangle(meeting.triangle), a);
    if (meeting.to_on) point_on_plane(own, triangle(meeting.triangle), b);
    if (!meeting.crosses) return;
    const auto [entry, is_new] = isect.crossing_.try_emplace({edge, meeting.cluster}, 0);
    if (is_new) entry.value() = complex.point_at(meeting.place, complex.weld_distance());
    const PointId point = entry->second;
    if (std::ranges::find(split_by, meeting.cluster) == split_by.end()) {
      split_by.push_back(meeting.cluster);
      splits.push_back({edge, point});
    }
    complex.imprint_point(meeting.cluster, point);
    add_event(own, meeting.cluster, point);
  }

  // A triangle of the cluster comes within `reach` of the place.
  [[nodiscard]] bool in_region(ClusterId cluster, const dvec3& place, double reach) const {
    constexpr std::size_t kFew = 16;  // a walk over so many is quicker than a search
    const auto own = triangulation.of_cluster(cluster);
    if (own.size() > kFew) return search.in_region(cluster, place, reach);
    return std::ranges::any_of(
        own, [&](std::uint32_t i) { return triangulation.alive()[i] && search.distance(place, triangle(i)) <= reach; });
  }

  // Both ends lie on the plane: the edge itself is the contact.
  void imprint_contact(EdgeKey edge, ClusterId cluster) {
    const auto [a, b] = ends_of(edge);
    const dvec3 from = complex.place(a), to = complex.place(b);
    if (std::ranges::find(complex.items(edge), Item::imprint(cluster)) != complex.items(edge).end()) return;
    bool over = false;
    for (int i = 1; i < kContactSamples && !over; ++i) {
      over = in_region(cluster, from + (static_cast<double>(i) / kContactSamples) * (to - from), band);
    }
    if (!over || !isect.contacts_.insert({edge, cluster}).second) return;
    imprint_edge(edge, cluster);
  }

  void imprint_edge(EdgeKey edge, ClusterId cluster) {
    complex.toggle(edge, Item::imprint(cluster));
    for (const PointId point : ends_of(edge)) complex.imprint_point(cluster, point);
    changed = true;
  }

  void look_at(EdgeKey edge, std::span<const Meeting> meetings) {
    const Owners list = owners(edge);
    const std::span<const ClusterId> own(list.data(), list.size());
    std::vector<ClusterId> split_by, flat;
    for (const Meeting& meeting : meetings) {
      cut(edge, own, meeting, split_by);
      if (meeting.from_on && meeting.to_on) flat.push_back(meeting.cluster);
    }
    std::sort(flat.begin(), flat.end());
    flat.erase(std::unique(flat.begin(), flat.end()), flat.end());
    for (const ClusterId cluster : flat) imprint_contact(edge, cluster);
  }

  // The points on both planes in the order of their common line.
  [[nodiscard]] std::vector<PointId> ordered(ClusterId a, ClusterId b, std::span<const Event> known) const {
    const dvec3 line = glm::cross(plane(a).normal, plane(b).normal);
    constexpr double kLeastSine = 1e-9;  // below it the planes have no line that double numbers could tell
    if (known.size() < 2 || glm::length(line) < kLeastSine) return {};
    std::vector<PointId> list;
    for (const Event& event : known) {
      if (complex.present(event.second)) list.push_back(event.second);
    }
    std::sort(list.begin(), list.end(), [&](PointId u, PointId v) {
      const double difference = glm::dot(complex.place(u) - complex.place(v), line);
      return difference != 0 ? difference < 0 : complex.precedes(u, v);
    });
    return list;
  }

  void imprint_chords(ClusterPair pair) {
    const auto a = static_cast<ClusterId>(pair >> 32), b = static_cast<ClusterId>(pair);
    const std::vector<PointId> line = ordered(a, b, std::ranges::equal_range(isect.events_, pair, {}, &Event::first));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const dvec3 middle = 0.5 * (complex.place(line[i]) + complex.place(line[i + 1]));
      const auto in = [&](ClusterId cluster) {
        return std::abs(plane(cluster).height(middle)) <= tolerance && in_region(cluster, middle, tolerance / 2);
      };
      const EdgeKey edge = edge_key(line[i], line[i + 1]);
      if (!in(a) || !in(b) || !isect.chords_.insert({pair, edge}).second) continue;
      for (const ClusterId cluster : {a, b}) {
        if (!complex.edge_in_cluster(edge, cluster)) imprint_edge(edge, cluster);
      }
    }
  }

  // Adds the new events to those known; the pairs that have any, ascending.
  [[nodiscard]] std::vector<ClusterPair> take_events() {
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    std::vector<Event> added;
    std::ranges::set_difference(events, isect.events_, std::back_inserter(added));
    std::vector<ClusterPair> pairs;
    for (const Event& event : added) {
      if (pairs.empty() || pairs.back() != event.first) pairs.push_back(event.first);
    }
    const auto known = static_cast<std::ptrdiff_t>(isect.events_.size());
    isect.events_.insert(isect.events_.end(), added.begin(), added.end());
    std::inplace_merge(isect.events_.begin(), isect.events_.begin() + known, isect.events_.end());
    return pairs;
  }
};

// The edges that are new, and those that new triangles are near; ascending.
std::vector<EdgeKey> Isect::edges_to_look_at(const Triangulation& triangulation) {
  complex_.refresh_search();
  const std::uint32_t first_new = search_.first_new();
  search_.update(triangulation);
  const auto added = complex_.edges_added();
  std::vector<EdgeKey> edges(added.begin() + static_cast<std::ptrdiff_t>(edges_seen_), added.end());
  const bool all_are_new = edges_seen_ == 0;
  edges_seen_ = added.size();
  const auto inflation = static_cast<std::int32_t>(std::ceil(complex_.tolerance()));
  const auto triangles = triangulation.triangles();
  for (std::uint32_t i = first_new; i < triangles.size() && !all_are_new; ++i) {
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
  std::vector<std::vector<Meeting>> meetings(edges.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) meetings[i] = pass.meetings_of(edges[i]);
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!meetings[i].empty()) pass.look_at(edges[i], meetings[i]);
  }
  for (const ClusterPair pair : pass.take_events()) pass.imprint_chords(pair);
  for (const auto& [edge, point] : pass.splits) pass.changed |= complex_.split(edge, point);
  return pass.changed;
}

}  // namespace rad::repair
