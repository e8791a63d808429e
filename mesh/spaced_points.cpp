#include "mesh/spaced_points.h"

#include <algorithm>
#include <cmath>

#include "geom/lattice.h"
#include "geom/predicates.h"

namespace rad::mesh {

// Cells as wide as the spacing; 2^21 of them an axis hold every lattice from a spacing of 8 pitches on, and below that
// several cells share a key, which costs time only.
std::uint64_t SpacedPoints::cell(const geom::LatticePoint& point, int dx, int dy, int dz) const {
  const auto index = [&](std::int32_t coordinate, int shift) {
    const double along = std::floor((coordinate + static_cast<double>(geom::kLatticeLimit)) / spacing_) + shift;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(along)) & 0x1fffff;
  };
  return index(point.x, dx) << 42 | index(point.y, dy) << 21 | index(point.z, dz);
}

void SpacedPoints::add(const geom::LatticePoint& point) { cells_[cell(point, 0, 0, 0)].push_back(point); }

bool SpacedPoints::any_near(const geom::LatticePoint& point) const {
  const double squared = spacing_ * spacing_;
  for (int neighbour = 0; neighbour < 27; ++neighbour) {
    const auto found = cells_.find(cell(point, neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1));
    if (found == cells_.end()) continue;
    const bool near = std::any_of(found->second.begin(), found->second.end(), [&](const geom::LatticePoint& other) {
      return static_cast<double>(geom::squared_distance(point, other)) < squared;
    });
    if (near) return true;
  }
  return false;
}

bool SpacedPoints::add_if_spaced(const geom::LatticePoint& point) {
  if (any_near(point)) return false;
  add(point);
  return true;
}

}  // namespace rad::mesh
