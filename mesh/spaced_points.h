// A set of lattice points that keep a distance.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geom/vec.h"

namespace rad::mesh {

class SpacedPoints {
 public:
  /// `spacing` in pitches, at least 1.
  explicit SpacedPoints(double spacing) : spacing_(spacing) {}

  /// Adds a point whatever is near.
  void add(const geom::LatticePoint& point);
  /// Adds the point unless one is nearer than the spacing; says whether it did.
  bool add_if_spaced(const geom::LatticePoint& point);

  [[nodiscard]] bool any_near(const geom::LatticePoint& point) const;

 private:
  [[nodiscard]] std::uint64_t cell(const geom::LatticePoint& point, int dx, int dy, int dz) const;
  double spacing_;
  std::unordered_map<std::uint64_t, std::vector<geom::LatticePoint>> cells_;
};

}  // namespace rad::mesh
