// What materials say of light.
#pragma once

#include <span>
#include <string>

#include "mesh/radiosity_mesh.h"
#include "scene/scene.h"

namespace rad::solve {

using geom::dvec3;

/// Radiant exitance of a diffuse material, W/m² per channel: stated as such, or π times a stated luminance.
dvec3 exitance(const scene::Material& material);

/// True where a patch of positive area has a material that emits.
bool has_emitters(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials);

/// The first material that no solution exists for, and why: reflectance outside [0, 1), emission below 0, or a number
/// that is none. Empty where every material is sound.
std::string light_problem(std::span<const scene::Material> materials);

}  // namespace rad::solve
