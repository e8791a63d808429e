// Meshes in KHR_draco_mesh_compression, decoded with the Draco library.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.h"

namespace rad::readers::gltf {

struct DracoMesh {
  std::vector<geom::dvec3> positions;  ///< as stored: integers where the attribute is quantised by glTF
  bool stored_as_integers = false;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< corners are not held against the number of positions
  std::string fault;                                    ///< what went wrong, one clause; the mesh is empty then
};

/// Decodes a Draco stream; `position_id` is the unique id of its position attribute. A stream that claims more than
/// `largest_count` points or triangles is a fault.
DracoMesh decode_draco(std::string_view stream, std::uint32_t position_id, std::uint64_t largest_count);

}  // namespace rad::readers::gltf
