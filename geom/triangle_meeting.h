// Whether two triangles of a mesh meet elsewhere than in the corners and edges that they share: exact, no tolerance.
#pragma once

#include <array>

#include "geom/predicates.h"

namespace rad::geom {

/// Whether the closed segment and the closed triangle, which has area, have a point in common.
bool segment_meets_triangle(const LatticePoint& from, const LatticePoint& to,
                            const std::array<LatticePoint, 3>& triangle);

/// Whether two triangles with area have a point in common beyond what equal corners imply: with one equal corner beyond
/// that corner, with two beyond that edge. Triangles with three equal corners meet.
bool meet_beyond_shared_corners(const std::array<LatticePoint, 3>& a, const std::array<LatticePoint, 3>& b);

}  // namespace rad::geom
