// Images of a model that is written somewhere else.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rad::cli {

/// Makes the materials of `scene`, which was read from `input`, refer to images that `output` finds, and writes those.
/// A GLB gets the bytes of PNG, JPEG, WebP, KTX2 and AVIF files into itself. Other formats that hold images get the
/// files at the same place beside the output, by their name alone where that would be above its folder; embedded images
/// of an OBJ become files named after it. Images that are not found, and those named by an absolute path, stay as they
/// are. Returns why an image was not written: a file that is there already and is another, or what the system says.
std::string bring_images(scene::Scene& scene, const std::string& input, const std::string& output);

}  // namespace rad::cli
