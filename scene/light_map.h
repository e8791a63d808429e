// The light of a scene as images over its faces.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace rad::scene {

/// What a display makes of the images.
enum class LightMapLook : std::uint8_t {
  Unlit,     ///< the image is the colour that is shown
  Emissive,  ///< the image times the white luminance of the face is the luminance
};

struct LightMap {
  LightMapLook look = LightMapLook::Unlit;
  std::vector<std::shared_ptr<const Image>> pages;  ///< 8-bit sRGB; never null
  std::vector<std::uint32_t> page_of_face;          ///< of each face of the scene
  std::vector<dvec2> coordinates;       ///< of each corner of the scene, 0..1 from the upper left corner of its page
  std::vector<double> white_luminance;  ///< of each face, cd/m², above 0: what 1 is in the image there
  double clamped_share = 0;             ///< share of the area with a channel above white
};

}  // namespace rad::scene
