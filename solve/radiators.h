// The patches of a mesh as radiators: where they lie, and how the values at their nodes make up their mean.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "mesh/radiosity_mesh.h"
#include "solve/receivers.h"

namespace rad::solve {

/// What the values at the corners and the centre of a polygon add to the mean of the quadratic through them (see
/// shape_at_centre); the sum is 1. Exact for a triangle and a parallelogram, and for the bilinear part of any
/// quadrilateral.
Shares mean_shares(std::span<const dvec3> corners);

/// Corners and centre of an element as locals of its patch; for a triangle the fourth is the first, with a share of 0.
using ElementLocals = std::array<std::uint32_t, 5>;

/// A patch. Its locals are the nodes of its elements, each once, and the centres of its elements.
struct Radiator {
  dvec3 centre{0, 0, 0};
  double radius = 0;            ///< of the ball round `centre` that holds the patch
  dvec3 centroid{0, 0, 0};      ///< of the area
  std::array<dvec3, 2> axis{};  ///< orthogonal, in the patch, of length 1/radius
  double element_radius = 0;    ///< half the longest diagonal or edge of its elements
  double area = 0;              ///< sum over the elements, file units²
  std::uint32_t first_local = 0;
  std::uint32_t local_count = 0;
  std::uint32_t first_element = 0;
  std::uint32_t element_count = 0;

  /// Of a point of the patch from its centroid, in radii.
  [[nodiscard]] std::array<double, 2> coordinates(const dvec3& point) const {
    return {glm::dot(point - centroid, axis[0]), glm::dot(point - centroid, axis[1])};
  }
};

struct Radiators {
  std::vector<Radiator> patch;  ///< one for each patch of the mesh
  std::vector<ReceiverId> local_receiver;
  std::vector<std::array<double, 2>> local_slope;  ///< what a local adds to the slopes along the two axes
  std::vector<double> local_share;                 ///< of a local in the mean over its patch; they add to 1
  std::vector<ElementLocals> element;              ///< one for each element of the mesh

  [[nodiscard]] std::span<const ReceiverId> receivers_of(const Radiator& radiator) const {
    return std::span(local_receiver).subspan(radiator.first_local, radiator.local_count);
  }
  [[nodiscard]] std::span<const std::array<double, 2>> slopes_of(const Radiator& radiator) const {
    return std::span(local_slope).subspan(radiator.first_local, radiator.local_count);
  }
  [[nodiscard]] std::span<const double> shares_of(const Radiator& radiator) const {
    return std::span(local_share).subspan(radiator.first_local, radiator.local_count);
  }
};

/// The mean and the slopes of a patch are those of the plane that fits its radiosity best, in the mean over its area.
Radiators radiators_of(const mesh::RadiosityMesh& mesh, std::span<const Receiver> receivers);

}  // namespace rad::solve
