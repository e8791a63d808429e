// Lengths that meshing keeps, derived from T.
#pragma once

#include <glm/geometric.hpp>

#include "geom/tolerance.h"
#include "geom/vec.h"

namespace rad::mesh {

/// The least distance in pitches between points that meshing makes, and of such a point to any edge that it does not
/// belong to: the weld distance, plus 2 pitches for what rounding two points to the lattice takes (√3/2 each).
inline double least_spacing(const geom::Tolerance& tolerance) {
  return geom::kWeldRatio * static_cast<double>(tolerance.pitches) + 2;
}

/// How far from a common end two edges in these directions (unit length) are nearer than `spacing` to each other: beyond
/// spacing/sin θ they are not. 0 where they do not leave it on one side.
inline double reach_apart(const geom::dvec3& a, const geom::dvec3& b, double spacing) {
  if (glm::dot(a, b) <= 0) return 0;
  return spacing / glm::length(glm::cross(a, b));
}

/// What rounding its ends to the lattice can add to a length, in pitches: √3/2 each. A face that was drawn as a whole
/// number of patches wide is divided into as many, whichever way its corners were rounded.
inline constexpr double kLengthRounding = 2;

/// Shortest patch length that can be asked for, in T: two spacings fit, with room for rounding at T = 8 pitches.
inline constexpr double kShortestPatchInTolerances = 4;

}  // namespace rad::mesh
