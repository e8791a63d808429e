// Materials as glTF has them.
#pragma once

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace rad::writers::gltf {

/// Keeps the order in which members are made.
using Json = nlohmann::ordered_json;

inline constexpr const char* kUnlit = "KHR_materials_unlit";
inline constexpr const char* kEmissiveStrength = "KHR_materials_emissive_strength";

/// A dielectric, fully rough material: reflectance as base colour, exitance / π (cd/m²) as emission, by a strength
/// where that is above 1. Unlit, or where glTF cannot say it (a reflectance that no file stated or outside 0..1),
/// `extras.radfix` holds reflectance and exitance. Colours that are not finite count as 0. With a reference to a
/// texture (not null) the base colour is the factor of the texture, and the record says what reflectance it counts as.
Json material_json(const scene::Material& material, bool unlit, Json texture_reference = nullptr);

/// What glTF cannot say of a material: "reflectance" and "exitance" (W/m²), both finite, and "stated" where no file
/// stated the reflectance.
Json material_record(const scene::Material& material);

/// Three numbers.
Json triple_json(const geom::dvec3& value);

}  // namespace rad::writers::gltf
