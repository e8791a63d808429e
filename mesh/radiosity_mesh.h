// What a radiosity solver works on: patches that radiate, elements and their nodes that receive. Flat arrays, so that a
// solver can be tested on meshes made by hand.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"
#include "scene/scene.h"

namespace rad::mesh {

using geom::dvec3;
using NodeId = std::uint32_t;
using PatchId = std::uint32_t;

/// Corners of a triangle or a quadrilateral, counter-clockwise seen from the front; `count` is 3 or 4.
struct Corners {
  std::array<NodeId, 4> node{};
  std::uint32_t count = 3;

  [[nodiscard]] std::span<const NodeId> all() const& { return std::span(node).first(count); }
  void all() const&& = delete;  // would outlive its corners
};

/// A receiver: one point of one sector of a surface. Where surfaces meet, where another face stands on the surface and
/// along slits there is a node for each sector, since radiosity may jump there (paper 3.4.3, receivers at vertices).
struct Node {
  dvec3 position;           ///< file units
  dvec3 normal;             ///< unit length, to the front
  dvec3 inward;             ///< unit direction in the surface into the sector; zero where the sector is the whole disc
  double element_size = 0;  ///< length of the shortest edge of its elements, file units
};

/// A radiator: planar and convex.
struct Patch {
  Corners corners;
  scene::MaterialId material = 0;
  dvec3 normal;     ///< unit length, to the front
  double area = 0;  ///< file units²
};

/// A leaf of the tri-quad tree of a patch, anchored: no node lies inside one of its edges on the same surface.
struct Element {
  Corners corners;
  PatchId patch = 0;
};

struct RadiosityMesh {
  std::vector<Node> nodes;
  std::vector<Patch> patches;
  std::vector<Element> elements;  ///< by patch, ascending; the elements of a patch cover it
  double tolerance = 0;           ///< T of the model, file units
  double pitch = 0;               ///< of the lattice, file units
};

}  // namespace rad::mesh
