// Surfaces of Radiance as polygons.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geom/vec.h"

namespace rad::readers::radiance {

/// The polygons of one surface, in its own frame. Curved ones are divided as curve_division.h says.
struct Shape {
  std::vector<geom::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;  ///< rings of points, anticlockwise seen from the front
  std::vector<std::vector<std::uint32_t>> holes;  ///< of face 0
};

/// Whether this type names a surface that shape_of() can make.
bool is_surface(std::string_view type);

/// The shape of a surface of this type from its real arguments. Empty, with a clause in `problem`, where their number
/// is wrong or a size is not positive.
Shape shape_of(std::string_view type, std::span<const double> reals, std::string& problem);

}  // namespace rad::readers::radiance
