// The edges of patches by their points: which patches meet there, of whatever surface.
#pragma once

#include <vector>

#include "mesh/element_mesh.h"

namespace rad::mesh {

/// Edges with more patches keep the first of them by id.
struct PatchEdge {
  static constexpr std::uint32_t kMost = 4;
  std::array<std::uint32_t, 2> ends{};  ///< points, ascending
  std::array<PatchId, kMost> patch{};
  std::array<std::uint8_t, kMost> edge{};  ///< of the patch
  std::uint32_t count = 0;
  bool same_way = false;  ///< two patches run along it in one direction
};

/// Edges that do not lie inside a face: those with one patch, with patches of several faces, or with more than two.
/// Ascending by ends.
std::vector<PatchEdge> crease_edges(const ElementMesh& mesh);

}  // namespace rad::mesh
