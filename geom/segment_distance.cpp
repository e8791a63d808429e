#include "geom/segment_distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::geom {
namespace {

dvec3 nearest_on(const dvec3& point, const Segment& segment) {
  const dvec3 along = segment[1] - segment[0];
  const double squared = glm::dot(along, along);
  if (squared == 0) return segment[0];
  return segment[0] + along * std::clamp(glm::dot(point - segment[0], along) / squared, 0.0, 1.0);
}

// The foot on the triangle's plane where it lies in the triangle, else a corner; the edges are looked at elsewhere.
dvec3 foot_inside(const dvec3& point, const std::array<dvec3, 3>& t) {
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double squared = glm::dot(normal, normal);
  if (squared == 0) return t[0];
  const dvec3 foot = point - normal * (glm::dot(point - t[0], normal) / squared);
  for (std::size_t i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], foot - t[i]), normal) < 0) return t[i];
  }
  return foot;
}

}  // namespace

double length(const Segment& segment) { return glm::distance(segment[0], segment[1]); }

Segment shortest_between(const Segment& a, const Segment& b) {
  const dvec3 u = a[1] - a[0], v = b[1] - b[0], w = a[0] - b[0];
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double denominator = uu * vv - uv * uv;
  // Where the lines are nearest; for parallel ones the ends tell.
  if (denominator > 0) {
    const double s = (uv * glm::dot(v, w) - vv * glm::dot(u, w)) / denominator;
    const double t = (uu * glm::dot(v, w) - uv * glm::dot(u, w)) / denominator;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return {a[0] + u * s, b[0] + v * t};
  }
  Segment best{a[0], nearest_on(a[0], b)};
  for (const Segment& other :
       {Segment{a[1], nearest_on(a[1], b)}, Segment{nearest_on(b[0], a), b[0]}, Segment{nearest_on(b[1], a), b[1]}}) {
    if (length(other) < length(best)) best = other;
  }
  return best;
}

Segment shortest_between(const Segment& segment, const std::array<dvec3, 3>& triangle) {
  Segment best{segment[0], triangle[0]};
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment other = shortest_between(segment, Segment{triangle[i], triangle[(i + 1) % 3]});
    if (length(other) < length(best)) best = other;
  }
  for (const dvec3& end : segment) {
    const Segment other{end, foot_inside(end, triangle)};
    if (length(other) < length(best)) best = other;
  }
  return best;
}

}  // namespace rad::geom
