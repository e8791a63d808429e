// Slivers: a point of a cluster within T of a diagonal of its triangulation that no flip removes.

#include <algorithm>
#include <cmath>
#include <limits>

#include "repair/distance.h"
#include "repair/residual_round.h"

namespace rad::repair {
namespace {

constexpr std::array<double, 6> kShares{0.5, 0.35, 0.65, 0.2, 0.8, 0.1};
// Steiner points keep the weld distance from everything; where there is no room for that, a little more than T.
constexpr double kTightClearance = 1.02;
// No farther from the point than this many weld distances or the length of the diagonal.
constexpr double kFarthest = 3;

struct Ahead {
  EdgeKey edge = 0;
  double distance = std::numeric_limits<double>::infinity();
  dvec3 place{0, 0, 0};
};

// The first edge of the cluster that the ray from a point meets; `across` is perpendicular to it in the plane.
Ahead first_edge_ahead(const Complex& complex, ClusterId cluster, PointId from, const dvec3& direction,
                       const dvec3& across) {
  Ahead first;
  for (const EdgeKey edge : complex.clusters()[cluster].edges) {
    const auto [a, b] = ends_of(edge);
    if (a == from || b == from) continue;
    const dvec3 to_a = complex.place(a) - complex.place(from), to_b = complex.place(b) - complex.place(from);
    const double side_a = glm::dot(to_a, across), side_b = glm::dot(to_b, across);
    if ((side_a > 0) == (side_b > 0)) continue;
    const dvec3 place = to_a + side_a / (side_a - side_b) * (to_b - to_a);
    const double away = glm::dot(place, direction);
    const bool nearer = away < first.distance || (away == first.distance && edge < first.edge);
    if (away > 0 && nearer) first = {edge, away, complex.place(from) + place};
  }
  return first;
}

}  // namespace

bool Residual::Round::place_steiner(ClusterId cluster, PointId point, const dvec3& direction, double room,
                                    double edge_length) {
  const double weld = complex.weld_distance();
  for (const double clearance : {weld, kTightClearance * complex.tolerance()}) {
    for (const double share : kShares) {
      const double away = std::min(room * share, std::max(kFarthest * weld, edge_length));
      if (away < clearance || room - away < clearance) continue;
      dvec3 place = complex.place(point) + away * direction;
      place = glm::round(place - plane(cluster).height(place) * plane(cluster).normal);
      bool is_free = true;
      complex.for_each_point_near(place, clearance, [&](PointId id) {
        is_free = is_free && glm::distance(complex.place(id), place) > clearance;
      });
      for (const EdgeKey edge : complex.clusters()[cluster].edges) {
        if (!is_free) break;
        const auto [a, b] = ends_of(edge);
        is_free = geom::distance_to_segment(place, complex.place(a), complex.place(b)) > clearance;
      }
      if (!is_free) continue;
      const PointId steiner = complex.point_at(place, 0);
      changed |= complex.imprint_point(cluster, steiner);
      residual.steiner_.insert(steiner);
      ++residual.counts_.steiner_points;
      return true;
    }
  }
  return false;
}

// A Steiner point on the far side of the diagonal, seen from the point through it, draws the diagonal away. Without
// room for one the point is joined to the edge ahead.
void Residual::Round::relieve_sliver(const Triangle& t, PointId u, PointId v, PointId point) {
  const dvec3 diagonal = complex.place(v) - complex.place(u);
  dvec3 direction = glm::normalize(glm::cross(plane(t.cluster).normal, diagonal));
  const dvec3 foot =
      complex.place(u) + share_along(complex.place(point), complex.place(u), complex.place(v)) * diagonal;
  if (glm::dot(direction, foot - complex.place(point)) < 0) direction = -direction;
  const Ahead ahead = first_edge_ahead(complex, t.cluster, point, direction, diagonal);
  const bool bounded = std::isfinite(ahead.distance);
  if (bounded && place_steiner(t.cluster, point, direction, ahead.distance, glm::length(diagonal))) return;
  if (bounded) {
    const PointId end = complex.point_at(ahead.place, reach);
    const auto [a, b] = ends_of(ahead.edge);
    if (end != a && end != b) splits.push_back({ahead.edge, end});
    imprints.push_back({t.cluster, edge_key(point, end)});
  }
  if (effort != Effort::Forced) return;
  for (const std::uint32_t i : triangulation.of_cluster(t.cluster)) {
    const Triangle& other = triangle(i);
    if (!other.has(u) || !other.has(v) || other.has(point)) continue;
    for (const PointId apex : other.points) {
      if (apex != u && apex != v) imprints.push_back({t.cluster, edge_key(point, apex)});
    }
  }
}

}  // namespace rad::repair
