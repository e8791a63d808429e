#include "repair/crossing_point.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace rad::repair {
namespace {

constexpr double kOffPlane = 1;        // T
constexpr double kFarthestAlong = 16;  // T: below 3.6° angles count no more
constexpr double kLeastSine = 1e-9;

}  // namespace

PointId crossing_point(Complex& complex, EdgeKey edge, const Plane& plane, const dvec3& place, double reach) {
  const auto [a, b] = ends_of(edge);
  const dvec3 from = complex.place(a), to = complex.place(b);
  const double sine = std::abs(glm::dot(glm::normalize(to - from), plane.normal));
  const double tolerance = complex.tolerance();
  const double along = tolerance * std::min(kFarthestAlong, kOffPlane / std::max(sine, kLeastSine));
  if (along <= reach) return complex.point_at(place, reach);
  PointId best = scene::kNoPoint;
  double best_distance = std::numeric_limits<double>::infinity();
  complex.for_each_point_near(place, along, [&](PointId id) {
    const dvec3 point = complex.place(id);
    const double away = glm::distance(point, place);
    if (away > along || std::abs(plane.height(point)) > kOffPlane * tolerance) return;
    if (geom::distance_to_segment(point, from, to) > tolerance) return;
    if (away > best_distance || (away == best_distance && complex.precedes(best, id))) return;
    best = id;
    best_distance = away;
  });
  return best == scene::kNoPoint ? complex.point_at(place, reach) : best;
}

}  // namespace rad::repair
