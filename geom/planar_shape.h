// The shape of a convex polygon in its plane.
#pragma once

#include <span>

namespace rad::geom {

/// A point of a plane in an orthonormal frame of it.
struct PlanePoint {
  double x = 0;
  double y = 0;
};

/// The paper's ρ = r/R (2.2) scaled so that the equilateral triangle and the square score 1: 2 r/R for a triangle,
/// √2 r/R for a quadrilateral, with r of the largest inscribed and R of the smallest enclosing circle. In (0, 1].
/// `corners` are the three or four corners of a convex polygon with area, counter-clockwise.
double scaled_shape(std::span<const PlanePoint> corners);

}  // namespace rad::geom
