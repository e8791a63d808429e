// Meshes in KHR_draco_mesh_compression, decoded with the Draco library.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.h"
#include "scene/corner_values.h"

namespace rad::readers::gltf {

/// Unique ids of attributes in a stream.
struct DracoIds {
  std::optional<std::uint32_t> position;  ///< nothing: whichever attribute the stream calls positions
  std::optional<std::uint32_t> texture_coordinates;
  std::optional<std::uint32_t> normals;
};

struct DracoMesh {
  std::vector<geom::dvec3> positions;  ///< as stored: integers where the attribute is quantised by glTF
  bool stored_as_integers = false;
  std::vector<scene::dvec2> texture_coordinates;        ///< as many as positions, or none: floats only
  std::vector<geom::dvec3> normals;                     ///< likewise
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< corners are not held against the number of positions
  std::map<std::string, double> numbers;                ///< metadata of the stream
  std::string fault;                                    ///< what went wrong, one clause; the mesh is empty then
};

/// Decodes a Draco stream. A stream that claims more than `largest_count` points or triangles is a fault.
DracoMesh decode_draco(std::string_view stream, const DracoIds& ids, std::uint64_t largest_count);

}  // namespace rad::readers::gltf
