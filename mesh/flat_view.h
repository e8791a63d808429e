// The exact projection of a face: along the axis that it faces most, mirrored where that shows its back.
#pragma once

#include <cmath>
#include <utility>

#include "geom/predicates.h"

namespace rad::mesh {

/// What is counter-clockwise seen from the front is counter-clockwise in the projection.
class FlatView {
 public:
  FlatView() = default;
  /// `normal` points to the front; its length does not matter.
  explicit FlatView(const geom::dvec3& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    dropped_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    mirrored_ = normal[dropped_] < 0;
  }

  [[nodiscard]] int dropped() const { return dropped_; }
  [[nodiscard]] geom::PlanarPoint of(const geom::LatticePoint& point) const {
    const geom::PlanarPoint seen = geom::project(point, dropped_);
    return mirrored_ ? geom::PlanarPoint{seen.v, seen.u} : seen;
  }

 private:
  int dropped_ = 2;
  bool mirrored_ = false;
};

}  // namespace rad::mesh
