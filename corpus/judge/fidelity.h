// How far two sets of triangles are from each other, by brute force: what repair has lost or added.
#pragma once

#include <array>
#include <vector>

#include "geom/lattice.h"

namespace rad::corpus {

using PlacedTriangle = std::array<geom::dvec3, 3>;

/// How far points of the triangles of `from` that have `depth` of their own triangle around them are from all of `to`,
/// at most: of each triangle the deepest point and some others. A triangle less than 2 `depth` wide has no such point.
/// Infinite where `to` is empty and there is such a point. Points in the box `except` do not count.
double farthest_deep_point(const std::vector<PlacedTriangle>& from, const std::vector<PlacedTriangle>& to, double depth,
                           const geom::Box& except = {});

/// How far corners, middles and middles of edges of `from` are from all of `to`, at most.
double farthest_point(const std::vector<PlacedTriangle>& from, const std::vector<PlacedTriangle>& to,
                      const geom::Box& except = {});

}  // namespace rad::corpus
