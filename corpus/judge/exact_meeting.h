// Whether two triangles meet elsewhere than they may, in integers.
#pragma once

#include <array>

#include "geom/vec.h"

namespace rad::corpus {

using TriangleCorners = std::array<geom::LatticePoint, 3>;

/// Whether the triangle has no area.
bool has_no_area(const TriangleCorners& triangle);

/// Whether the closed segment and the closed triangle have a point in common. The triangle must have area.
bool segment_meets_triangle(const geom::LatticePoint& from, const geom::LatticePoint& to,
                            const TriangleCorners& triangle);

/// Whether two triangles with area, of which at most two corners are equal, meet outside of their common corner or
/// edge.
bool meet_improperly(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace rad::corpus
