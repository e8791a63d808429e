// The triangles of a planar region with their neighbours, and Lawson's flips on them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/constrained_triangulation.h"
#include "geom/planar_shape.h"
#include "geom/predicates.h"

namespace rad::mesh {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffU;

/// Edge i runs from corner i to corner i+1; `across[i]` is the triangle there, or kNoTriangle. A fixed edge stays.
struct LinkedTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<std::uint32_t, 3> across{kNoTriangle, kNoTriangle, kNoTriangle};
  std::array<bool, 3> fixed{};

  /// The edge that runs from `from` to `to`; it must exist.
  [[nodiscard]] std::size_t edge_from(std::uint32_t from, std::uint32_t to) const {
    for (std::size_t i = 0; i < 2; ++i) {
      if (corner[i] == from && corner[i + 1] == to) return i;
    }
    return 2;
  }
  [[nodiscard]] std::uint32_t opposite(std::size_t edge) const { return corner[(edge + 2) % 3]; }
};

std::vector<LinkedTriangle> linked(std::span<const geom::PolygonTriangle> triangles);

/// Flips edges until the triangulation is Delaunay in the plane of the face (`plane`), which the projection (`flat`)
/// squeezes; every triangle stays counter-clockwise in the projection, exactly.
void flip_to_delaunay(std::vector<LinkedTriangle>& triangles, std::span<const geom::PlanarPoint> flat,
                      std::span<const geom::PlanePoint> plane);

}  // namespace rad::mesh
