// The plane of a cluster: a tolerant thing, in rounded numbers. Exact questions are asked of the projected points.
#pragma once

#include "geom/predicates.h"
#include "repair/point_grid.h"

namespace rad::repair {

struct Plane {
  dvec3 normal{0, 0, 1};  ///< unit length
  double offset = 0;      ///< pitches
  int axis = 2;           ///< left out when projecting: the one along which the normal is longest
  bool mirrored = false;  ///< the normal points down that axis, and projecting swaps the two others

  Plane() = default;
  /// `normal` of any length but zero.
  Plane(const dvec3& normal, const LatticePoint& through);

  /// Signed distance, pitches.
  [[nodiscard]] double height(const dvec3& place) const {
    return normal.x * place.x + normal.y * place.y + normal.z * place.z - offset;
  }
  [[nodiscard]] double height(const LatticePoint& point) const { return height(geom::as_vector(point)); }
  /// Counter-clockwise in the projection is counter-clockwise seen from where the normal points.
  [[nodiscard]] geom::PlanarPoint project(const LatticePoint& point) const {
    const geom::PlanarPoint flat = geom::project(point, axis);
    return mirrored ? geom::PlanarPoint{flat.v, flat.u} : flat;
  }
};

}  // namespace rad::repair
