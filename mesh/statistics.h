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

struct PatchStatistics {
  std::size_t triangles = 0;
  std::size_t quads = 0;
  double longest_edge = 0;  ///< file units
  ShapePercentiles shape;   ///< zeros without patches
};
PatchStatistics patch_statistics(const PatchMesh& mesh);

struct ElementStatistics {
  std::size_t leaves = 0;
  std::size_t nodes = 0;
  std::size_t deepest_level = 0;
};
ElementStatistics element_statistics(const ElementMesh& mesh);

}  // namespace rad::mesh
