// Planar outlines of DXF: polylines with arcs, and the walls that their thickness raises.
#pragma once

#include <vector>

#include "readers/dxf_surfaces.h"

namespace rad::readers::dxf {

/// A corner of an outline in its object frame, and the bulge of the segment that starts there: the tangent of a quarter
/// of the arc's angle, 0 for a straight one, positive for an arc to the left.
struct OutlinePoint {
  dvec3 at{0, 0, 0};
  double bulge = 0;
  std::uint64_t line = 0;
};

/// The outline with arcs divided into chords (curve_division.h).
std::vector<OutlinePoint> divided(const std::vector<OutlinePoint>& outline, bool closed);

/// A wall of height `thickness` along Z of the frame on each segment.
void add_walls(const std::vector<OutlinePoint>& outline, bool closed, double thickness, Surfaces& surfaces);

/// The flat face that the outline encloses, and with a thickness its walls and the opposite face: a solid.
void add_plate(const std::vector<OutlinePoint>& outline, double thickness, Surfaces& surfaces);

/// A thickness counts where it is not zero.
[[nodiscard]] bool has_thickness(double thickness);

}  // namespace rad::readers::dxf
