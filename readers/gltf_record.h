// What radfix writes of itself into the extras of a glTF document: lattice and tolerance, and what materials are where
// they are shown unlit.
#pragma once

#include <optional>

#include "readers/gltf_container.h"
#include "scene/scene.h"

namespace rad::readers::gltf {

/// Lattice and tolerance of `asset.extras.radfix`; nothing where they are absent or not finite numbers. Extras are
/// anyone's, so that nothing in them is an issue.
std::optional<scene::RecordedLattice> read_recorded_lattice(const Document& document);

/// Takes reflectance and exitance of a material from its `extras.radfix` where both stand there as three finite
/// numbers; `"stated": false` says that the reflectance is not one that a file stated.
void take_recorded_material(const Json& material_json, scene::Material& material);

/// Whether the images of a material are pages of a light map that radfix baked, and so no property of its surface.
bool shows_light_map(const Json& material_json);

}  // namespace rad::readers::gltf
