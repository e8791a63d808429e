// Patches made by hand for the element library: a sheet of squares, some of them cut into triangles.
#pragma once

#include "mesh/element_mesh.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

/// n by n squares of `size` pitches in one surface; one in three becomes two triangles.
inline mesh::ElementPatches sheet_of_patches(std::uint32_t n, std::int32_t size, std::uint64_t seed) {
  LatticeRandom random(seed);
  mesh::ElementPatches patches;
  patches.lattice.pitch = 1;
  patches.tolerance.pitches = 1;
  patches.tolerance.length = 1;
  for (std::uint32_t row = 0; row <= n; ++row) {
    for (std::uint32_t column = 0; column <= n; ++column) {
      patches.node_point.push_back(static_cast<std::uint32_t>(patches.points.size()));
      patches.points.push_back({static_cast<std::int32_t>(column) * size, static_cast<std::int32_t>(row) * size, 0});
    }
  }
  const auto add = [&](std::initializer_list<std::uint32_t> nodes) {
    mesh::Corners corners{{}, 0};
    for (const std::uint32_t node : nodes) corners.node[corners.count++] = node;
    patches.corners.push_back(corners);
    patches.sources.push_back({0, {0, 0, 1}, static_cast<double>(n) * n * size * size});
  };
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      const std::uint32_t a = row * (n + 1) + column, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (random.one_in(3)) {
        add({a, b, c});
        add({a, c, d});
      } else {
        add({a, b, c, d});
      }
    }
  }
  return patches;
}

}  // namespace rad::tests
