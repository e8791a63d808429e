// The shape of single faces: requirements 2d and 2e.
#pragma once

#include "validate/context.h"

namespace rad::validate {

/// Corners of all loops, as in the file.
std::uint64_t corner_count(const Context& context, FaceId face);

/// Requirement 2d; corners in line make a quadrilateral not strictly convex.
bool is_triangle_or_convex_quad(const Context& context, FaceId face);

/// The paper's ρ = r/R scaled so that the equilateral triangle and the square score 1: 2 r/R for a triangle, √2 r/R for
/// a convex quadrilateral with r of the largest inscribed and R of the smallest enclosing circle. In (0, 1]. The face
/// must be a triangle or convex quadrilateral.
double scaled_shape(const Context& context, FaceId face);

}  // namespace rad::validate
