// Triangulating a planar polygon with holes, exactly, on lattice points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/predicates.h"

namespace rad::geom {

/// Corners are indices into the input points; `boundary[i]` tells whether the edge from corner i to corner i+1 lies
/// on a ring of the input.
struct PolygonTriangle {
  std::array<std::uint32_t, 3> corners;
  std::array<bool, 3> boundary;
};

/// Triangles of the region that the rings enclose (odd crossings inside), counter-clockwise as the points are
/// projected. `points` are distinct; `rings` hold indices into them and may touch themselves and each other in
/// vertices and along edges (bridges to holes), but not cross. Empty where two ring edges cross.
std::vector<PolygonTriangle> triangulate_rings(std::span<const PlanarPoint> points,
                                               std::span<const std::vector<std::uint32_t>> rings);

/// An edge between two of the input points.
using PointEdge = std::array<std::uint32_t, 2>;

/// Constrained Delaunay triangles of the region that `outline` encloses (odd crossings inside), counter-clockwise.
/// All points are corners where they lie inside; `points` are distinct. Edges of `inner` are kept as edges and may end
/// anywhere. Edges may touch in points and overlap, but not cross; `boundary` of a triangle tells which of its edges
/// lie on an edge of `outline` or `inner`. Empty where two edges cross.
std::vector<PolygonTriangle> triangulate_region(std::span<const PlanarPoint> points, std::span<const PointEdge> outline,
                                                std::span<const PointEdge> inner);

}  // namespace rad::geom
