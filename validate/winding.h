// How often a component winds around a point.
#pragma once

#include "validate/context.h"

namespace rad::validate {

/// Sum of signed solid angles over 4π: near 1 inside an outward-facing closed component, -1 inside an inward-facing
/// one, 0 outside, about ±1/2 on its surface. `triangles` are indices into context.triangles. Linear in their number.
double winding_number(const Context& context, std::span<const std::uint32_t> triangles, const dvec3& lattice_point);

}  // namespace rad::validate
