// Where a point lies in a triangle, as shares of its corners.
#pragma once

#include <array>

#include "geom/vec.h"

namespace rad::scene {

/// Shares of the corners at the point of a triangle nearest to `point`: 0..1, adding up to 1; exactly 1 at a corner.
/// The triangle may lack area.
std::array<double, 3> nearest_shares(const std::array<geom::dvec3, 3>& place, const geom::dvec3& point);

/// Σ share[i] · value[i].
template <typename Value>
Value blend(const std::array<Value, 3>& value, const std::array<double, 3>& share) {
  return value[0] * share[0] + value[1] * share[1] + value[2] * share[2];
}

}  // namespace rad::scene
