// The texture statement of MTL.
#pragma once

#include <string>

#include "scene/texture.h"

namespace rad::writers {

/// Appends map_Kd with the path of the image and, where they differ from what MTL takes by default, its scale, offset
/// and clamping. The image must not be embedded.
void append_texture(std::string& text, const scene::Texture& texture);

}  // namespace rad::writers
