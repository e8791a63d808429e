// Writing a scene as PLY.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes binary little-endian PLY: every vertex in its order with x, y, z as double and, where there is light, B_r,
/// B_g, B_b as double (radiosity, W/m²) and red, green, blue as uchar (the colour, sRGB); every face that has a corner
/// as a list, holes reached over bridges. Lost, for PLY has no place for it: materials, objects, groups.
WriteResult write_ply(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
