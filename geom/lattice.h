// The scene lattice: the one grid of power-of-two pitch that all geometry after reading lives on.
#pragma once

#include "geom/vec.h"

namespace rad::geom {

/// Coordinates of lattice points are smaller than this in magnitude (24-bit signed integers).
inline constexpr std::int32_t kLatticeLimit = 1 << 23;

/// Axis-aligned box in file units; `empty()` until the first point is added.
struct Box {
  dvec3 low{1, 1, 1};
  dvec3 high{-1, -1, -1};

  [[nodiscard]] bool empty() const { return low.x > high.x; }
  [[nodiscard]] double diagonal() const;
  [[nodiscard]] double largest_magnitude() const;
  void add(const dvec3& point);
};

/// Maps file coordinates to lattice points and back. `position(nearest(p))` is within pitch·√3/2 of p, and exact in
/// single precision relative to `origin`.
struct Lattice {
  double pitch = 1;       ///< file units, a power of two
  dvec3 origin{0, 0, 0};  ///< file units, a multiple of a power of two near the box centre

  [[nodiscard]] LatticePoint nearest(const dvec3& point) const;
  [[nodiscard]] dvec3 position(const LatticePoint& point) const;
};

/// The finest lattice that holds `box` with every |coordinate| below kLatticeLimit. A box without extent gets the
/// pitch of a box as large as its coordinates' magnitude times 2^-20 (or 1 at the origin), so that a pitch always
/// exists.
Lattice lattice_for(const Box& box);

/// Whether this is a lattice (finite origin; pitch a power of two and a normal number) on which every |coordinate| of
/// `box` is below kLatticeLimit. False for an empty box.
bool holds(const Lattice& lattice, const Box& box);

}  // namespace rad::geom
