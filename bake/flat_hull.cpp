#include "bake/flat_hull.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace rad::bake {
namespace {

// A rectangle is smaller only where it is so by more than rounding.
constexpr double kSmaller = 1 - 1e-9;

double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

dvec2 left_of(const dvec2& v) { return {-v.y, v.x}; }

FlatRectangle rectangle_along(std::span<const dvec2> hull, const dvec2& along) {
  const dvec2 across = left_of(along);
  dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const dvec2& point : hull) {
    const dvec2 at{glm::dot(point, along), glm::dot(point, across)};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  if (high.x - low.x >= high.y - low.y) {
    return {along * low.x + across * low.y, along, high.x - low.x, high.y - low.y};
  }
  // A quarter turn on: the new side along `across` starts where `along` ends.
  return {along * high.x + across * low.y, across, high.y - low.y, high.x - low.x};
}

}  // namespace

std::vector<dvec2> convex_hull(std::span<const dvec2> points) {
  std::vector<dvec2> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, [](const dvec2& a, const dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<dvec2> hull;
  const auto walk = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *point) <= 0) hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  if (sorted.size() < 3) return sorted;
  walk(sorted.begin(), sorted.end());
  walk(sorted.rbegin(), sorted.rend());
  return hull;
}

FlatRectangle least_rectangle(std::span<const dvec2> points) {
  const std::vector<dvec2> hull = convex_hull(points);
  FlatRectangle least;
  double area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = glm::length(edge);
    if (length <= 0) continue;
    const FlatRectangle rectangle = rectangle_along(hull, edge / length);
    if (rectangle.length * rectangle.breadth >= kSmaller * area) continue;
    area = rectangle.length * rectangle.breadth;
    least = rectangle;
  }
  return least;
}

}  // namespace rad::bake
