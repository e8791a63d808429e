// Charts of a light map: flat parts of surfaces, each with a frame of its own.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "mesh/radiosity_mesh.h"

namespace rad::bake {

using geom::dvec3;
using glm::dvec2;
using mesh::PatchId;

/// Patches of one plane and material that are connected through edges with common nodes, so that radiosity is
/// continuous all over the chart. Seen from the front, `right` and `down` are what their names say.
struct LightChart {
  std::vector<PatchId> patches;  ///< ascending
  dvec3 origin{0, 0, 0};         ///< upper left corner of the least rectangle around them, file units
  dvec3 right{1, 0, 0};          ///< unit length, along the longer side
  dvec3 down{0, 1, 0};           ///< unit length, at right angles to it
  double width = 0;              ///< of the rectangle, file units; not below height
  double height = 0;             ///< above 0

  /// Along right and down from the origin, file units.
  [[nodiscard]] dvec2 in_plane(const dvec3& position) const;
};

/// The charts of a mesh, by their first patches; every patch is in one. A part into which an edge reaches that
/// separates its two sides (a wall that ends inside a floor) is cut in the line of that edge, along edges of patches: a
/// texel never holds what is on the other side.
std::vector<LightChart> light_charts(const mesh::RadiosityMesh& mesh);

}  // namespace rad::bake
