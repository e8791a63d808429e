// Materials of a written glTF document that show a light map.
#pragma once

#include "scene/light_map.h"
#include "writers/gltf_materials.h"

namespace rad::writers::gltf {

/// The image of a page, filtered bilinearly without coarser levels and not repeated.
scene::Texture light_map_texture(const scene::LightMap& map, std::uint32_t page);

/// A material that shows a page on TEXCOORD_1; `reference` is that of its texture. Unlit: the page is the colour.
/// Emissive: it is the emission, times `white_luminance` by KHR_materials_emissive_strength (cd/m²), and nothing is
/// reflected. `extras.radfix` holds the page beside reflectance and exitance.
Json light_map_material_json(const scene::Material& material, scene::LightMapLook look, std::uint32_t page,
                             double white_luminance, Json reference);

}  // namespace rad::writers::gltf
