// Radiosity over one element, as a function of the plane.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rad::bake {

using glm::dvec2;
using glm::dvec3;

/// What an element says of a point: the value there and how it changes along both axes.
struct FlatValue {
  dvec3 value{0, 0, 0};
  dvec3 along_x{0, 0, 0};
  dvec3 along_y{0, 0, 0};
};

/// A triangle or a convex quadrilateral with a value at each corner, linear or bilinear in between. Corners go around
/// clockwise where y points down, and enclose an area.
struct FlatElement {
  std::array<dvec2, 4> corner{};
  std::array<dvec3, 4> value{};
  std::uint32_t count = 3;

  /// Whether the point lies inside or within `margin` of the lines of all edges.
  [[nodiscard]] bool contains(const dvec2& point, double margin) const;

  /// Value and slopes at a point inside or on the border.
  [[nodiscard]] FlatValue at(const dvec2& point) const;
};

}  // namespace rad::bake
