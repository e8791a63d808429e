// Constrained Delaunay triangulation of points and edges in a plane, with neighbours: what the labels of a plane
// cluster spread over.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/predicates.h"

namespace rad::geom {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// Counter-clockwise. Edge i runs from corner i to corner i+1; `neighbour[i]` lies across it.
struct PlanarTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<std::uint32_t, 3> neighbour{kNoTriangle, kNoTriangle, kNoTriangle};
  std::array<bool, 3> constrained{};
};

/// Why the triangulation is not what was asked for. Indices of points and edges as they were given.
struct PlanarConflicts {
  std::vector<std::array<std::uint32_t, 2>> coinciding;     ///< points at one place; the first of them was used
  std::vector<std::array<std::uint32_t, 2>> point_on_edge;  ///< edge, point inside it: the edge was split there
  std::vector<std::uint32_t> crossing;                      ///< edges left out because they cross an earlier one

  [[nodiscard]] bool none() const { return coinciding.empty() && point_on_edge.empty() && crossing.empty(); }
};

struct PlanarMesh {
  std::vector<PlanarTriangle> triangles;  ///< of the convex hull; empty where all points lie on a line
  PlanarConflicts conflicts;

  /// Replaces the common edge of `triangle` and its neighbour across `edge` by the other diagonal of the two. The edge
  /// must not be constrained and the two must form a strictly convex quadrilateral.
  void flip(std::uint32_t triangle, int edge);
};

/// Points are below 2^25 in magnitude; edges are pairs of indices of different points. Exact. The result depends on the
/// order of points only where more than three lie on an empty circle.
PlanarMesh constrained_delaunay(std::span<const PlanarPoint> points,
                                std::span<const std::array<std::uint32_t, 2>> edges);

}  // namespace rad::geom
