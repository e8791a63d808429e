// Rings that cross in the plane of their face and pass each other in space: faces so warped that they fold over in it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace rad::repair {

/// More corners are not triangulated: the search takes the cube of their number.
inline constexpr std::size_t kMostCornersInSpace = 256;

/// Whether two edges of the ring that have no corner in common come within T of each other in space.
bool meets_itself(std::span<const geom::LatticePoint> ring, std::int64_t tolerance);

/// The triangles with the corners of the ring that have the least area in sum (Barequet and Sharir 1995): what spans it
/// when its plane does not tell. Indices into the ring, each triangle in its sense. O(n³).
std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const geom::LatticePoint> ring);

}  // namespace rad::repair
