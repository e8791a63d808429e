// Clipping in the plane of a lattice triangle. Constructed points are rounded to double: about 2^-28 of a pitch.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "geom/predicates.h"

namespace rad::geom {

/// A convex region in the plane of a triangle, in lattice units.
struct PlanarRegion {
  double area = 0;
  double diameter = 0;  ///< of the region's corners
  dvec3 centroid{0, 0, 0};
};

/// `subject` projected along the normal of `plane` onto it, cut to the triangle `clip` that spans the plane.
PlanarRegion clipped_to_triangle(const std::array<LatticePoint, 3>& subject, const std::array<LatticePoint, 3>& clip,
                                 const TrianglePlane& plane);

/// Where the way from `from` to `to`, two points of the plane, enters and leaves the triangle, as shares of it: 0 to 1.
/// Nothing where it misses the triangle by more than about 2^-10 pitches: what was constructed on an edge is found
/// there whichever way it was rounded. The points may be equal.
std::optional<std::array<double, 2>> share_in_triangle(const dvec3& from, const dvec3& to,
                                                       const std::array<LatticePoint, 3>& clip,
                                                       const TrianglePlane& plane);

}  // namespace rad::geom
