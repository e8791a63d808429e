// The surfaces of one glTF mesh in its own frame, before any node places it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "readers/gltf_accessors.h"
#include "scene/corner_values.h"

namespace rad::readers::gltf {

struct Triangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t record = 0;  ///< index of the triangle in the primitive, counting those left out
};

struct Primitive {
  std::string pointer;
  std::string group;  ///< that radfix recorded for it; empty where it belongs to that of the mesh
  std::optional<std::uint64_t> material;
  std::optional<std::uint64_t> position_accessor;  ///< primitives of one mesh with the same share their vertices
  std::optional<std::uint64_t> texture_accessor;   ///< likewise their rows of texture coordinates
  std::optional<std::uint64_t> normal_accessor;
  std::vector<geom::dvec3> positions;
  std::vector<scene::dvec2> texture_coordinates;  ///< as many as positions, or none
  std::vector<geom::dvec3> normals;               ///< likewise
  std::vector<Triangle> triangles;                ///< every corner is below positions.size()
};

/// The primitives of a mesh that could be read, in order. Triangles with an index out of range are reported and left
/// out; points, lines and morph targets are counted as unsupported. `texture_sets` says for each material which set of
/// texture coordinates its primitives keep; set 0 where there is no material.
std::vector<Primitive> read_mesh(const Document& document, const Buffers& buffers, const Accessors& accessors,
                                 std::span<const std::uint64_t> texture_sets, std::uint64_t mesh);

}  // namespace rad::readers::gltf
