// The unit and axes that assimp has put into the root of what it read.
#pragma once

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace rad::readers::assimp {

struct Frame {
  std::optional<double> metres_per_unit;
  scene::UpAxis up = scene::UpAxis::Unknown;
  glm::dmat4 root{1.0};  ///< what is left of the root's matrix
};

glm::dmat4 matrix_of(const aiMatrix4x4& matrix);

/// COLLADA and 3DS: importers scale and turn the root to metres with Y up; where that is all that the root does, it is
/// undone, so that coordinates stay the file's, and stated instead. FBX states both in its metadata; X3D and LWO have
/// them by definition, 3MF its unit.
Frame frame_of(const aiScene& scene, std::string_view format);

}  // namespace rad::readers::assimp
