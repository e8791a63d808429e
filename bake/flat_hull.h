// The least rectangle around points of a plane.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace rad::bake {

using glm::dvec2;

/// From `corner`, `length` along `along` (unit length) and `breadth` along (-along.y, along.x).
struct FlatRectangle {
  dvec2 corner{0, 0};
  dvec2 along{1, 0};
  double length = 0;  ///< not below breadth
  double breadth = 0;
};

/// The convex hull: its corners counter-clockwise where y points up, without points inside its edges.
std::vector<dvec2> convex_hull(std::span<const dvec2> points);

/// The rectangle of the least area around the points, with one side along an edge of their convex hull; of equal ones
/// the first. The points do not all lie on a line.
FlatRectangle least_rectangle(std::span<const dvec2> points);

}  // namespace rad::bake
