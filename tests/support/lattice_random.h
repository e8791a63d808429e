// Random lattice points, with the degenerate arrangements that uniform ones never show.
#pragma once

#include <cstdint>
#include <random>

#include "geom/lattice.h"

namespace rad::tests {

class LatticeRandom {
 public:
  explicit LatticeRandom(std::uint64_t seed) : engine_(seed) {}

  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(std::int64_t n) { return between(0, n - 1) == 0; }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// A coordinate of one of the magnitudes that matter: small, any, or at the very ends of the range.
  std::int32_t coordinate() {
    constexpr std::int32_t kLargest = geom::kLatticeLimit - 1;
    switch (between(0, 3)) {
      case 0:
        return static_cast<std::int32_t>(between(-4, 4));
      case 1:
        return one_in(2) ? kLargest : -kLargest;
      case 2:
        return static_cast<std::int32_t>((one_in(2) ? 1 : -1) * (kLargest - between(0, 3)));
      default:
        return static_cast<std::int32_t>(between(-kLargest, kLargest));
    }
  }
  geom::LatticePoint point() {
    const std::int32_t x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  /// A point with every coordinate a multiple of `step` from -reach·step to reach·step.
  geom::LatticePoint grid_point(std::int64_t reach, std::int64_t step) {
    const std::int64_t x = between(-reach, reach), y = between(-reach, reach), z = between(-reach, reach);
    return {static_cast<std::int32_t>(x * step), static_cast<std::int32_t>(y * step),
            static_cast<std::int32_t>(z * step)};
  }

 private:
  std::mt19937_64 engine_;
};

inline geom::LatticePoint moved_by(const geom::LatticePoint& p, std::int64_t x, std::int64_t y, std::int64_t z) {
  return {static_cast<std::int32_t>(p.x + x), static_cast<std::int32_t>(p.y + y), static_cast<std::int32_t>(p.z + z)};
}

}  // namespace rad::tests
