// Materials of Radiance, of scene files and of HBJSON, as diffuse reflectance and radiant exitance.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace rad::readers::radiance {

/// What a material becomes. Colours are per channel; emission is radiant exitance in W/m².
struct Optics {
  geom::dvec3 reflectance{0.5, 0.5, 0.5};
  bool reflectance_stated = false;
  geom::dvec3 emission{0, 0, 0};
  std::string lost;            ///< what of it diffuse surfaces cannot show: "specular reflection"; empty for nothing
  bool is_antimatter = false;  ///< cuts other surfaces away: no surface of its own
};

/// Whether this type names a material, which surfaces may have, and not a pattern, texture or mixture.
bool is_material(std::string_view type);

/// The diffuse part of a material of this type from its real arguments, by the definitions of the Radiance reference:
/// plastic and metal reflect C (1 - specularity), trans that times (1 - transmission), both sides alike; glass and
/// mirrors nothing diffusely; light, glow, illum and spotlight have a radiance L, so an exitance π L. Too few arguments
/// leave the reflectance unstated.
Optics optics_of(std::string_view type, std::span<const double> reals);

/// Puts them into a material of a scene.
void apply(const Optics& optics, scene::Material& material);

}  // namespace rad::readers::radiance
