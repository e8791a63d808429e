// A scene through the file that a user gets.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rad::corpus {

/// The bytes of the GLB that is written of the scene, with the lattice that it records. Throws std::runtime_error where
/// the file cannot be written.
std::string glb_bytes(const scene::Scene& scene);

scene::Scene scene_of_glb(const std::string& bytes);

}  // namespace rad::corpus
