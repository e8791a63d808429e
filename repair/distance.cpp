#include "repair/distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::repair {

double share_along(const dvec3& place, const dvec3& from, const dvec3& to) {
  const dvec3 way = to - from;
  const double square = glm::dot(way, way);
  return square > 0 ? std::clamp(glm::dot(place - from, way) / square, 0.0, 1.0) : 0;
}

std::array<dvec3, 2> nearest_of_segments(const std::array<dvec3, 2>& a, const std::array<dvec3, 2>& b) {
  const dvec3 along_a = a[1] - a[0], along_b = b[1] - b[0];
  const double aa = glm::dot(along_a, along_a), bb = glm::dot(along_b, along_b), ab = glm::dot(along_a, along_b);
  const dvec3 between = a[0] - b[0];
  const double determinant = aa * bb - ab * ab;
  double share = 0;
  if (determinant > 0) {
    share = std::clamp((ab * glm::dot(along_b, between) - bb * glm::dot(along_a, between)) / determinant, 0.0, 1.0);
  }
  const dvec3 on_b = b[0] + share_along(a[0] + share * along_a, b[0], b[1]) * along_b;
  const dvec3 on_a = a[0] + share_along(on_b, a[0], a[1]) * along_a;
  return {on_a, on_b};
}

dvec3 nearest_on_triangle(const dvec3& place, const std::array<dvec3, 3>& v) {
  const dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
  const double square = glm::dot(normal, normal);
  if (square > 0) {
    const dvec3 foot = place - (glm::dot(place - v[0], normal) / square) * normal;
    const auto left_of = [&](int i) { return glm::dot(glm::cross(v[(i + 1) % 3] - v[i], foot - v[i]), normal) >= 0; };
    if (left_of(0) && left_of(1) && left_of(2)) return foot;
  }
  dvec3 best = v[0];
  double best_distance = glm::distance(place, best);
  for (int i = 0; i < 3; ++i) {
    const dvec3& from = v[i];
    const dvec3& to = v[(i + 1) % 3];
    const dvec3 candidate = from + share_along(place, from, to) * (to - from);
    const double away = glm::distance(place, candidate);
    if (away >= best_distance) continue;
    best_distance = away;
    best = candidate;
  }
  return best;
}

double distance_to_triangle(const dvec3& place, const std::array<dvec3, 3>& corners) {
  return glm::distance(place, nearest_on_triangle(place, corners));
}

double distance_to_triangle(const dvec3& place, const std::array<geom::LatticePoint, 3>& corners) {
  return distance_to_triangle(place,
                              {geom::as_vector(corners[0]), geom::as_vector(corners[1]), geom::as_vector(corners[2])});
}

}  // namespace rad::repair
