// The materials of a glTF document as diffuse reflectance and emission.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "readers/gltf_textures.h"
#include "scene/scene.h"

namespace rad::readers::gltf {

/// Of a material that looks no coordinates up.
inline constexpr std::uint64_t kNoTextureSet = std::numeric_limits<std::uint64_t>::max();

struct ReadMaterial {
  scene::Material material;
  std::uint64_t texture_set = 0;  ///< TEXCOORD_n of its texture, or kNoTextureSet
};

/// One material for each of the document, with a name of its own ("material N" where it has none). Reflectance is
/// baseColorFactor × (1 − metallicFactor), or the base colour alone where the material is unlit; emission is
/// emissiveFactor × strength in cd/m². Images are not looked at: under a base colour texture the unknown colour
/// counts as 0.5, and under a metalness texture the unknown metal share as 0; neither is then "stated". What radfix
/// recorded of a material goes before all that. The base colour texture is kept as a reference, but for the
/// pages of a light map that radfix baked.
std::vector<ReadMaterial> read_materials(const Document& document, const Buffers& buffers);

}  // namespace rad::readers::gltf
