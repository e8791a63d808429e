// Counts and shapes of a mesh for the report.
#pragma once

#include <array>
#include <cstddef>

#include "mesh/element_mesh.h"
#include "mesh/patch_mesh.h"

namespace rad::mesh {

/// Scaled ρ (geom/planar_shape.h): 1 is best.
struct ShapePercentiles {
  double least = 0;
  double first = 0;  ///< percentile
  double fifth = 0;
  double median = 0;
};

/// Below it no patch at the corner is in good shape, whatever the method.
inline constexpr double kBluntDegrees = 30;

struct PatchStatistics {
  std::size_t triangles = 0;
  std::size_t quads = 0;
  double longest_edge = 0;                  ///< file units
  double area = 0;                          ///< file units²
  ShapePercentiles shape;                   ///< zeros without patches
  std::array<std::size_t, 10> histogram{};  ///< patches by ρ: below 0.1, below 0.2, ...
  std::size_t blunt_patches = 0;            ///< of faces without a corner below kBluntDegrees
  ShapePercentiles blunt_shape;
};
PatchStatistics patch_statistics(const PatchMesh& mesh);

struct ElementStatistics {
  std::size_t leaves = 0;
  std::size_t nodes = 0;
  std::size_t deepest_level = 0;
  double bytes_per_leaf = 0;  ///< of memory, nodes included
};
ElementStatistics element_statistics(const ElementMesh& mesh);

}  // namespace rad::mesh
