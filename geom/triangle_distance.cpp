#include "geom/triangle_distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::geom {
namespace {

dvec3 nearest_on_segment(const dvec3& a, const dvec3& b, const dvec3& p) {
  const dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  if (squared == 0) return a;
  return a + std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) * along;
}

}  // namespace

dvec3 nearest_point(std::array<LatticePoint, 3> triangle, const LatticePoint& point) {
  // In one order, so that rounding is the same whichever way the triangle is turned.
  std::ranges::sort(triangle);
  // Relative to the point: small numbers near it.
  const dvec3 origin = as_vector(point);
  const std::array<dvec3, 3> corner{as_vector(triangle[0]) - origin, as_vector(triangle[1]) - origin,
                                    as_vector(triangle[2]) - origin};
  const dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double squared = glm::dot(normal, normal);
  if (squared > 0) {
    const dvec3 foot = normal * (glm::dot(normal, corner[0]) / squared);
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3 edge = corner[(i + 1) % 3] - corner[i];
      inside = inside && glm::dot(glm::cross(edge, foot - corner[i]), normal) >= 0;
    }
    if (inside) return origin + foot;
  }
  dvec3 nearest = corner[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 candidate = nearest_on_segment(corner[i], corner[(i + 1) % 3], dvec3(0));
    if (glm::dot(candidate, candidate) < glm::dot(nearest, nearest)) nearest = candidate;
  }
  return origin + nearest;
}

}  // namespace rad::geom
