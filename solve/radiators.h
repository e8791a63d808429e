// The patches of a mesh as radiators: where they lie, and how the values at their nodes make up their mean.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/radiosity_mesh.h"
#include "solve/strata.h"

namespace rad::solve {

/// What the value at each corner of a polygon adds to the mean of the bilinear (of three corners: linear) interpolant over
/// it; the sum is 1. Exact for a planar polygon.
std::array<double, 4> mean_shares(std::span<const dvec3> corners);

/// A patch. Its nodes are those of its elements, each once: the local nodes.
struct Radiator {
  dvec3 centre;
  double radius = 0;                     ///< of the ball round `centre` that holds the patch
  double area = 0;                       ///< sum over the elements, file units²
  std::uint32_t first_local = 0;         ///< in Radiators::local_node and local_share
  std::uint32_t local_count = 0;
  std::uint32_t first_element = 0;
  std::uint32_t element_count = 0;
};

struct Radiators {
  std::vector<Radiator> patch;                          ///< one for each patch of the mesh
  std::vector<mesh::NodeId> local_node;
  std::vector<double> local_share;                      ///< of a node in the mean over its patch; they add to 1
  std::vector<std::array<std::uint32_t, 4>> corner;     ///< of each element, as local nodes of its patch

  [[nodiscard]] std::span<const mesh::NodeId> nodes_of(const Radiator& radiator) const {
    return std::span(local_node).subspan(radiator.first_local, radiator.local_count);
  }
  [[nodiscard]] std::span<const double> shares_of(const Radiator& radiator) const {
    return std::span(local_share).subspan(radiator.first_local, radiator.local_count);
  }
};

Radiators radiators_of(const mesh::RadiosityMesh& mesh);

/// The corners of an element or a patch in space.
Stratum stratum_of(const mesh::Corners& corners, const mesh::RadiosityMesh& mesh);

}  // namespace rad::solve
