// Writing a scene as OFF.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes OFF as text: every vertex in its order, every face that has a corner, holes reached over bridges; numbers
/// are the shortest that read back the same. Lost, for OFF has no place for it: materials, objects,
/// groups, texture coordinates, normals, light.
WriteResult write_off(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
