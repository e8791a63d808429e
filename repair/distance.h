// Rounded distances between points, segments and triangles.
#pragma once

#include <array>

#include "geom/vec.h"

namespace rad::repair {

using geom::dvec3;

/// The point of the closed segment nearest to `place`, as a share of the way: 0 to 1.
double share_along(const dvec3& place, const dvec3& from, const dvec3& to);

/// The two points of two closed segments that are nearest to each other; for parallel ones some such pair.
std::array<dvec3, 2> nearest_of_segments(const std::array<dvec3, 2>& a, const std::array<dvec3, 2>& b);

dvec3 nearest_on_triangle(const dvec3& place, const std::array<dvec3, 3>& corners);
double distance_to_triangle(const dvec3& place, const std::array<dvec3, 3>& corners);
double distance_to_triangle(const dvec3& place, const std::array<geom::LatticePoint, 3>& corners);

}  // namespace rad::repair
