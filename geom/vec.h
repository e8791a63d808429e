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

}  // namespace rad::geom
