// Clipping in the plane of a lattice triangle. Constructed points are rounded to double: about 2^-28 of a pitch.
#pragma once

#include "geom/predicates.h"

#include <array>
#include <optional>
#include <span>

namespace rad::geom {

/// A convex region in the plane of a triangle, in lattice units.
struct PlanarRegion {
  double area = 0;
  double diameter = 0;          ///< of the region's corners
  dvec3 centroid{0, 0, 0};
};

/// `subject` projected along the dominant axis of `plane` onto it, cut to the triangle `clip` that spans the plane.
PlanarRegion clipped_to_triangle(const std::array<LatticePoint, 3>& subject, const std::array<LatticePoint, 3>& clip,
                                 const TrianglePlane& plane);

/// The part of the segment whose projection lies in the triangle; a segment of length 0 is a point. Nothing where
/// there is none.
std::optional<std::array<dvec3, 2>> clipped_to_triangle(const dvec3& from, const dvec3& to,
                                                        const std::array<LatticePoint, 3>& clip,
                                                        const TrianglePlane& plane);

}  // namespace rad::geom
