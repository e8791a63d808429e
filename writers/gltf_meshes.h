// The meshes of a written glTF document: one for each object, split by material.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "writers/gltf_buffer.h"
#include "writers/gltf_frame.h"
#include "writers/model.h"

namespace rad::writers::gltf {

/// What a material of the document is made of.
struct MaterialUse {
  scene::MaterialId material = 0;
  std::uint32_t page = 0;      ///< of the light map; 0 without one
  double white_luminance = 0;  ///< of the light map; 0 without one
  friend constexpr auto operator<=>(const MaterialUse&, const MaterialUse&) = default;
};

struct WrittenMaterial {
  MaterialUse use;
  bool shows_texture = false;  ///< it has an image, and faces with coordinates for it
};

struct Meshes {
  std::string problem;  ///< why there are none; empty where all is well
  BufferBuilder buffer;
  Json meshes = Json::array();
  std::vector<scene::ObjectId> objects;    ///< of each mesh, ascending
  std::vector<WrittenMaterial> materials;  ///< of each material index in `meshes`, in their order
};

/// Splits the faces, packs the vertices and describes both.
Meshes build_meshes(const Output& output, const Frame& frame);

}  // namespace rad::writers::gltf
