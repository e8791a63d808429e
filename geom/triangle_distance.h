// The place of a triangle that is nearest to a point.
#pragma once

#include <array>

#include "geom/lattice.h"
#include "geom/vec.h"

namespace rad::geom {

/// In lattice units, rounded, the same to the last bit for every order of the corners. A triangle without area counts as its longest edge.
dvec3 nearest_point(std::array<LatticePoint, 3> triangle, const LatticePoint& point);

}  // namespace rad::geom
