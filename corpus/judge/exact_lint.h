// Triangles judged by brute force: every pair, in integers where the question is exact. Slow and plain on purpose; it
// shares no code with the lint that ends repair.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "geom/lattice.h"
#include "scene/scene.h"

namespace rad::corpus {

struct LatticeTriangles {
  std::vector<geom::LatticePoint> points;             ///< no two equal
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< counter-clockwise seen from the front
};

/// The faces of a scene of triangles. Nothing where one is no triangle or a vertex is not exactly on the lattice.
std::optional<LatticeTriangles> lattice_triangles(const scene::Scene& scene, const geom::Lattice& lattice);

struct ExactCounts {
  std::size_t degenerate = 0;     ///< triangles without area: exact
  std::size_t duplicates = 0;     ///< pairs with the same corners that look the same way: exact
  std::size_t intersections = 0;  ///< pairs that meet elsewhere than in common corners and edges: exact
  std::size_t overlaps = 0;       ///< triangles whose middle lies within `tolerance` of another that looks the same way
  std::size_t t_vertices = 0;     ///< pairs of an edge and a point within `tolerance` of its inside
  std::string first;              ///< where the first of them is, lattice coordinates; empty where there is none

  [[nodiscard]] bool clean() const { return degenerate + duplicates + intersections + overlaps + t_vertices == 0; }
};

/// `tolerance` in pitches. Legal: two triangles that lie on each other within the tolerance and look opposite ways.
/// O(n²) in triangles and in points times edges.
ExactCounts exact_lint(const LatticeTriangles& triangles, double tolerance);

}  // namespace rad::corpus
