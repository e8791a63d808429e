// The surfaces of one glTF mesh in its own frame, before any node places it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "readers/gltf_accessors.h"

namespace rad::readers::gltf {

struct Triangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t record = 0;  ///< index of the triangle in the primitive, counting those left out
};

struct Primitive {
  std::string pointer;
  std::optional<std::uint64_t> material;
  std::optional<std::uint64_t> position_accessor;  ///< primitives of one mesh with the same share their vertices
  std::vector<geom::dvec3> positions;
  std::vector<Triangle> triangles;  ///< every corner is below positions.size()
};

/// The primitives of a mesh that could be read, in order. Triangles with an index out of range are reported and left
/// out; points, lines and morph targets are counted as unsupported.
std::vector<Primitive> read_mesh(const Document& document, const Buffers& buffers, const Accessors& accessors,
                                 std::uint64_t mesh);

}  // namespace rad::readers::gltf
