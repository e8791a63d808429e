// Random points on polygons.
#pragma once

#include <array>

#include "solve/form_factor.h"
#include "solve/strata.h"

namespace rad::solve {

/// Uniform over the polygon of at least 3 corners, but for a quadrilateral that is no parallelogram: uniform in its
/// parameters there. `random` has two numbers in (0, 1).
dvec3 point_in(const ConvexPolygon& polygon, const std::array<double, 2>& random);
dvec3 point_in(const Stratum& stratum, const std::array<double, 2>& random);

}  // namespace rad::solve
