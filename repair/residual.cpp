#include "repair/residual.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/triangle_meeting.h"
#include "repair/distance.h"
#include "repair/normaliser.h"
#include "repair/residual_round.h"

namespace rad::repair {
namespace {

// Intersecting triangles within 3.6° of each other and this near, in T, are re-homed rather than cut along a line that
// hardly exists.
constexpr double kRehomeCosine = 0.998;
constexpr double kRehomeHeight = 1.5;
// Points this near a near-coplanar triangle, in T, are imprinted on it.
constexpr double kDrawTogether = 3;
// A split is refused where the point is this far off the edge, in reaches.
constexpr double kSplitReach = 1.5;
// A segment whose ends differ in height by less, pitches, or by less than this share of its length, lies in the plane.
constexpr double kFlatPitches = 2;
constexpr double kFlatShare = 1e-6;

}  // namespace

bool Residual::Round::imprint_point(ClusterId cluster, PointId id) {
  if (complex.in_cluster(id, cluster)) return false;
  changed |= complex.imprint_point(cluster, id);
  return true;
}

void Residual::Round::imprint_edge(ClusterId cluster, EdgeKey edge) {
  const auto [a, b] = ends_of(edge);
  if (a == b || complex.edge_in_cluster(edge, cluster)) return;
  if (!complex.may_imprint(cluster, a) || !complex.may_imprint(cluster, b)) return;
  if (!residual.imprinted_.insert({cluster, edge}).second) return;
  complex.toggle(edge, Item::imprint(cluster));
  complex.imprint_point(cluster, a);
  complex.imprint_point(cluster, b);
  changed = true;
}

bool Residual::Round::cure_stacking() {
  const Stacking& stacking = triangulation.stacking();
  std::vector<std::array<PointId, 2>> merges = stacking.points;
  for (const auto& [edge, point] : stacking.points_on_edges) {
    if (complex.split_shortens(edge, point)) {
      changed |= complex.split(edge, point, Need::Sound);
      continue;
    }
    const auto [a, b] = ends_of(edge);
    merges.push_back({complex.distance(a, point) < complex.distance(b, point) ? a : b, point});
  }
  // One only: the next may be of what is no longer there.
  return std::ranges::any_of(merges,
                             [&](const auto& pair) { return complex.merge_either(pair[0], pair[1], Need::Sound); }) ||
         changed;
}

bool Residual::Round::nearly_coplanar(const Triangle& a, const Triangle& b) const {
  if (a.cluster == b.cluster) return false;
  const dvec3 a_normal = normal(a), b_normal = normal(b);
  if (std::abs(glm::dot(a_normal, b_normal)) <= kRehomeCosine) return false;
  double a_height = 0, b_height = 0;
  for (const PointId id : a.points) a_height = std::max(a_height, std::abs(height(b, b_normal, id)));
  for (const PointId id : b.points) b_height = std::max(b_height, std::abs(height(a, a_normal, id)));
  return std::min(a_height, b_height) <= kRehomeHeight * complex.tolerance();
}

namespace {

// Where the segment meets the triangle: on its plane, or in the middle of what it has in common with it.
dvec3 meeting_place(const dvec3& from, const dvec3& to, const std::array<dvec3, 3>& v, const dvec3& normal) {
  const double at_from = glm::dot(from - v[0], normal), at_to = glm::dot(to - v[0], normal);
  const double fall = at_from - at_to;
  if (std::abs(fall) >= kFlatShare * glm::distance(from, to) && std::abs(fall) >= kFlatPitches) {
    return from + std::clamp(at_from / fall, 0.0, 1.0) * (to - from);
  }
  double enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    const dvec3 inward = glm::cross(normal, v[(i + 1) % 3] - v[i]);
    const double start = glm::dot(inward, from - v[i]), end = glm::dot(inward, to - v[i]);
    if (start == end) continue;
    const double share = start / (start - end);
    if (end > start) {
      enter = std::max(enter, share);
    } else {
      leave = std::min(leave, share);
    }
  }
  return from + std::clamp(0.5 * (enter + leave), 0.0, 1.0) * (to - from);
}

}  // namespace

void Residual::Round::cut_edges_of(const Triangle& s, const Triangle& t, std::vector<PointId>& common) {
  const std::array corners_of_t{complex.point(t.points[0]), complex.point(t.points[1]), complex.point(t.points[2])};
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId u = s.points[k], v = s.points[(k + 1) % 3];
    if (t.has(u) || t.has(v)) continue;
    if (!geom::segment_meets_triangle(complex.point(u), complex.point(v), corners_of_t)) continue;
    const dvec3 place = meeting_place(complex.place(u), complex.place(v), corners(t), normal(t));
    const PointId point = complex.point_at(place, reach);
    common.push_back(point);
    if (complex.has_edge(edge_key(u, v))) splits.push_back({edge_key(u, v), point});
    imprint_point(s.cluster, point);
    imprint_point(t.cluster, point);
  }
}

void Residual::Round::cut(const Triangle& a, const Triangle& b) {
  std::vector<PointId> common;
  cut_edges_of(a, b, common);
  cut_edges_of(b, a, common);
  for (const PointId id : a.points) {
    if (b.has(id)) common.push_back(id);
  }
  std::sort(common.begin(), common.end());
  common.erase(std::unique(common.begin(), common.end()), common.end());
  const dvec3 line = glm::cross(normal(a), normal(b));
  std::sort(common.begin(), common.end(), [&](PointId u, PointId v) {
    const double difference = glm::dot(complex.place(u) - complex.place(v), line);
    return difference != 0 ? difference < 0 : complex.precedes(u, v);
  });
  for (std::size_t i = 0; i + 1 < common.size(); ++i) {
    for (const ClusterId cluster : {a.cluster, b.cluster}) {
      imprints.push_back({cluster, edge_key(common[i], common[i + 1])});
    }
  }
}

// Two pieces that nearly coincide and cannot be given one plane: each gets the points and edges of the other.
void Residual::Round::draw_together(const Triangle& a, const Triangle& b, double near) {
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const dvec3 q_normal = normal(*q);
    for (const PointId id : p->points) {
      if (std::abs(height(*q, q_normal, id)) > near) continue;
      if (distance_to_triangle(complex.place(id), corners(*q)) <= near) imprint_point(q->cluster, id);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId u = p->points[k], v = p->points[(k + 1) % 3];
      if (!complex.in_cluster(u, q->cluster) || !complex.in_cluster(v, q->cluster)) continue;
      for (const ClusterId cluster : {p->cluster, q->cluster}) imprints.push_back({cluster, edge_key(u, v)});
    }
  }
}

// What draws them together, and where that is nothing new a common point for edges that cross.
void Residual::Round::overlay(const Triangle& a, const Triangle& b) {
  if (!adds(a, b, kDrawTogether * complex.tolerance())) join_edges(a, b);
}

// Two edges that pass each other within T get a point in common, half way between them.
bool Residual::Round::join_edges(const Triangle& a, const Triangle& b) {
  bool joined = false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const PointId u = a.points[i], v = a.points[(i + 1) % 3], p = b.points[j], q = b.points[(j + 1) % 3];
      if (u == p || u == q || v == p || v == q) continue;
      const auto [on_a, on_b] =
          nearest_of_segments({complex.place(u), complex.place(v)}, {complex.place(p), complex.place(q)});
      if (glm::distance(on_a, on_b) > complex.tolerance()) continue;
      const PointId point = complex.point_at(0.5 * (on_a + on_b), reach);
      for (const EdgeKey edge : {edge_key(u, v), edge_key(p, q)}) {
        if (complex.has_edge(edge)) splits.push_back({edge, point});
      }
      joined |= imprint_point(a.cluster, point);
      joined |= imprint_point(b.cluster, point);
    }
  }
  return joined;
}

// Draws them together; whether that plans anything new.
bool Residual::Round::adds(const Triangle& a, const Triangle& b, double near) {
  const std::size_t planned = imprints.size();
  const bool before = std::exchange(changed, false);
  draw_together(a, b, near);
  const bool new_edges =
      std::any_of(imprints.begin() + static_cast<std::ptrdiff_t>(planned), imprints.end(), [&](const auto& imprint) {
        return !complex.edge_in_cluster(imprint.second, imprint.first) && !residual.imprinted_.contains(imprint);
      });
  const bool drawn = changed || new_edges;
  changed |= before;
  return drawn;
}

// Two triangles that touch get each other's points and edges where they are within T, then points where edges pass each
// other; the line of a crossing last.
void Residual::Round::join(const Triangle& a, const Triangle& b) {
  if (!adds(a, b, complex.tolerance()) && !join_edges(a, b)) cut(a, b);
}

void Residual::Round::clear_edge(const Triangle& t, std::uint32_t corner, PointId point) {
  const PointId u = t.points[corner], v = t.points[(corner + 1) % 3];
  if (complex.has_edge(edge_key(u, v))) {
    splits.push_back({edge_key(u, v), point});
  } else if (!imprint_point(t.cluster, point)) {
    relieve_sliver(t, u, v, point);
  }
}

void Residual::Round::cure(const Violation& violation) {
  const Triangle& a = triangle(violation.a);
  if (violation.kind == ViolationKind::PointOnEdge) {
    clear_edge(a, violation.b, violation.point);
    return;
  }
  const Triangle& b = triangle(violation.b);
  const bool gone = moved[violation.a] || moved[violation.b];
  if (violation.kind == ViolationKind::NearCoplanar) {
    if (!gone && !rehome(violation)) overlay(a, b);
    return;
  }
  if (violation.kind == ViolationKind::Contact) {
    join(a, b);
    return;
  }
  const bool flat = nearly_coplanar(a, b);
  if (flat && gone) return;
  if (!flat || !rehome(violation)) cut(a, b);
}

bool Residual::Round::finish() {
  for (const auto& [edge, point] : splits) {
    const auto [a, b] = ends_of(edge);
    const double off = geom::distance_to_segment(complex.place(point), complex.place(a), complex.place(b));
    if (off > kSplitReach * reach || !complex.split_shortens(edge, point)) continue;
    changed |= complex.split(edge, point);
  }
  for (const auto& [cluster, edge] : imprints) imprint_edge(cluster, edge);
  return changed;
}

bool Residual::round(const Triangulation& triangulation, std::span<const Violation> violations, Effort effort,
                     double reach) {
  Round round(*this, triangulation, effort, reach);
  if (!triangulation.sound() && round.cure_stacking()) return true;
  complex_.refresh_search();
  if (effort == Effort::Merge) return round.merge_closest(violations);
  for (const Violation& violation : violations) {
    if (effort == Effort::OneKind && violation.kind != violations.front().kind) break;
    round.cure(violation);
  }
  return round.finish();
}

}  // namespace rad::repair
