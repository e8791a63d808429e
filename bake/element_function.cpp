#include "bake/element_function.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::bake {
namespace {

// Newton's steps on the bilinear map of a convex quadrilateral: one where it is a parallelogram; the error squares.
constexpr int kMostSteps = 20;
constexpr double kSettled = 1e-13;

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

// Slopes along x and y from those along s and t, of which the directions are given.
FlatValue with_slopes(const dvec3& value, const dvec3& along_s, const dvec3& along_t, const dvec2& s, const dvec2& t) {
  const double area = cross(s, t);
  if (area == 0) return {value, dvec3(0), dvec3(0)};
  return {value, (along_s * t.y - along_t * s.y) / area, (along_t * s.x - along_s * t.x) / area};
}

FlatValue in_triangle(const FlatElement& element, const dvec2& point) {
  const dvec2 s = element.corner[1] - element.corner[0], t = element.corner[2] - element.corner[0];
  const dvec2 way = point - element.corner[0];
  const double area = cross(s, t);
  const double u = cross(way, t) / area, v = cross(s, way) / area;
  const dvec3 along_s = element.value[1] - element.value[0], along_t = element.value[2] - element.value[0];
  return with_slopes(element.value[0] + u * along_s + v * along_t, along_s, along_t, s, t);
}

FlatValue in_quadrilateral(const FlatElement& element, const dvec2& point) {
  const auto& p = element.corner;
  const dvec2 skew = p[0] - p[1] + p[2] - p[3];
  dvec2 at(0.5, 0.5), s, t;
  for (int step = 0; step < kMostSteps; ++step) {
    s = p[1] - p[0] + skew * at.y;
    t = p[3] - p[0] + skew * at.x;
    const double area = cross(s, t);
    if (area == 0) break;
    const dvec2 left = point - (p[0] + (p[1] - p[0]) * at.x + (p[3] - p[0]) * at.y + skew * (at.x * at.y));
    const dvec2 change{cross(left, t) / area, cross(s, left) / area};
    // The point is in the element or on its border.
    at = {std::clamp(at.x + change.x, 0.0, 1.0), std::clamp(at.y + change.y, 0.0, 1.0)};
    if (std::max(std::abs(change.x), std::abs(change.y)) < kSettled) break;
  }
  const auto& b = element.value;
  const dvec3 twist = b[0] - b[1] + b[2] - b[3];
  const dvec3 along_s = b[1] - b[0] + twist * at.y, along_t = b[3] - b[0] + twist * at.x;
  s = p[1] - p[0] + skew * at.y;
  t = p[3] - p[0] + skew * at.x;
  return with_slopes(b[0] + (b[1] - b[0]) * at.x + (b[3] - b[0]) * at.y + twist * (at.x * at.y), along_s, along_t, s,
                     t);
}

}  // namespace

bool FlatElement::contains(const dvec2& point, double margin) const {
  for (std::uint32_t i = 0; i < count; ++i) {
    const dvec2 edge = corner[(i + 1) % count] - corner[i];
    if (cross(edge, point - corner[i]) < -margin * glm::length(edge)) return false;
  }
  return true;
}

FlatValue FlatElement::at(const dvec2& point) const {
  return count == 3 ? in_triangle(*this, point) : in_quadrilateral(*this, point);
}

}  // namespace rad::bake
