#include "solve/jitter_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

dvec3 point_in_triangle(const dvec3& a, const dvec3& b, const dvec3& c, double u, double v) {
  const double root = std::sqrt(u);
  return a + (b - a) * (root * (1 - v)) + (c - a) * (root * v);
}

/// Uniform over a polygon of any number of corners, as a fan of triangles.
dvec3 point_in_fan(const ConvexPolygon& polygon, const std::array<double, 2>& random) {
  std::array<double, 8> until{};
  const dvec3& apex = polygon.corner[0];
  for (std::uint32_t i = 2; i < polygon.count; ++i) {
    const dvec3 twice = glm::cross(polygon.corner[i - 1] - apex, polygon.corner[i] - apex);
    until[i] = until[i - 1] + glm::length(twice);
  }
  const double wanted = random[0] * until[polygon.count - 1];
  std::uint32_t i = 2;
  while (i + 1 < polygon.count && until[i] < wanted) ++i;
  const double within = until[i] > until[i - 1] ? (wanted - until[i - 1]) / (until[i] - until[i - 1]) : 0.5;
  return point_in_triangle(apex, polygon.corner[i - 1], polygon.corner[i], std::clamp(within, 0.0, 1.0), random[1]);
}

template <typename Corners>
dvec3 point_in_few(const Corners& corner, std::uint32_t count, const std::array<double, 2>& random) {
  const auto [u, v] = random;
  if (count == 3) return point_in_triangle(corner[0], corner[1], corner[2], u, v);
  return (corner[0] * (1 - u) + corner[1] * u) * (1 - v) + (corner[3] * (1 - u) + corner[2] * u) * v;
}

}  // namespace

dvec3 point_in(const ConvexPolygon& polygon, const std::array<double, 2>& random) {
  return polygon.count > 4 ? point_in_fan(polygon, random) : point_in_few(polygon.corner, polygon.count, random);
}

dvec3 point_in(const Stratum& stratum, const std::array<double, 2>& random) {
  return point_in_few(stratum.corner, stratum.count, random);
}

}  // namespace rad::solve
