#include "solve/form_factor.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace rad::solve {

ConvexPolygon above_horizon(std::span<const dvec3> polygon, const Receiver& receiver) {
  ConvexPolygon above;
  const std::size_t count = polygon.size();
  const bool whole = std::all_of(polygon.begin(), polygon.end(), [&](const dvec3& corner) {
    return glm::dot(corner - receiver.position, receiver.normal) > 0;
  });
  if (whole) {
    for (const dvec3& corner : polygon) above.corner[above.count++] = corner - receiver.position;
    return above;
  }
  dvec3 from = polygon[count - 1] - receiver.position;
  double from_height = glm::dot(from, receiver.normal);
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 to = polygon[i] - receiver.position;
    const double to_height = glm::dot(to, receiver.normal);
    if ((from_height > 0) != (to_height > 0)) {
      above.corner[above.count++] = from + (to - from) * (from_height / (from_height - to_height));
    }
    if (to_height > 0) above.corner[above.count++] = to;
    from = to;
    from_height = to_height;
  }
  if (above.count < 3) above.count = 0;
  return above;
}

double form_factor(const ConvexPolygon& polygon, const dvec3& normal) {
  double sum = 0;
  for (std::uint32_t i = 0; i < polygon.count; ++i) {
    const dvec3& from = polygon.corner[i];
    const dvec3& to = polygon.corner[i + 1 < polygon.count ? i + 1 : 0];
    const dvec3 across = glm::cross(from, to);
    const double length = glm::length(across);
    // An edge in line with the receiver turns through no angle; neither does one without length.
    if (length > 0) sum += std::atan2(length, glm::dot(from, to)) * glm::dot(normal, across) / length;
  }
  // Counter-clockwise from its front, the polygon turns clockwise round the line of sight: the sum is negative.
  return std::clamp(-sum / (2 * std::numbers::pi), 0.0, 1.0);
}

}  // namespace rad::solve
