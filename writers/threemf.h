// 3MF, for solids that are to be made.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// A mesh object of triangles for each object of the scene, with base materials in the colours of the reflectances. The
/// unit is the scene's where 3MF has it, else metres stand in the build transform.
WriteResult write_3mf(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
