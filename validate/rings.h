// Questions about the rings of one face, seen along the dominant axis of its normal. Exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/predicates.h"

namespace rad::validate {

using Ring = std::vector<std::uint32_t>;  ///< indices into planar points

/// Whether two edges of the rings cross in their interiors. Touching in vertices and running along each other (the
/// bridge to a hole) is not crossing. O(n²) for few edges, a sweep over one axis beyond.
bool edges_cross(std::span<const geom::PlanarPoint> points, std::span<const Ring> rings);

/// Whether the ring turns one way at every corner, exactly once around: strictly convex where `strict`, else corners
/// in line are allowed.
bool is_convex(std::span<const geom::PlanarPoint> points, const Ring& ring, bool strict);

/// Whether the point lies inside the ring or on it (odd crossings).
bool inside_or_on(std::span<const geom::PlanarPoint> points, const Ring& ring, const geom::PlanarPoint& point);

}  // namespace rad::validate
