// Materials and textures of CityJSON.
#pragma once

#include <vector>

#include "readers/json_view.h"
#include "scene/scene_builder.h"

namespace rad::readers::cityjson {

struct Appearance {
  std::vector<scene::MaterialId> materials;  ///< by number
  std::vector<scene::MaterialId> textures;   ///< by number: a material for each image
  std::size_t texture_rows = 0;              ///< of the table of texture coordinates
  std::string material_theme;                ///< that the file names as default; empty for none
  std::string texture_theme;
};

/// Reads member "appearance" of the file. Diffuse colours become reflectances as drawing_colour.h says; what has no
/// unit or passes light is counted.
Appearance read_appearance(const JsonView& root, scene::SceneBuilder& builder, scene::ReadIssues& issues);

}  // namespace rad::readers::cityjson
