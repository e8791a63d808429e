// Vector types shared by every layer.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>

namespace rad::geom {

using dvec3 = glm::dvec3;

/// A point of the scene lattice, in pitches from the lattice origin. Every coordinate is below 2^23 in magnitude, so
/// differences fit 24 bits and sign and every predicate of predicates.h fits fixed-width integers.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  friend constexpr auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// The same point as a vector, in pitches; exact.
inline dvec3 as_vector(const LatticePoint& point) { return {point.x, point.y, point.z}; }

/// Distance from `point` to the closed segment, rounded. The exact question is point_within_segment (predicates.h).
double distance_to_segment(const dvec3& point, const dvec3& from, const dvec3& to);

}  // namespace rad::geom
