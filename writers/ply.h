// Writing a scene as PLY.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes binary little-endian PLY: every vertex in its order with x, y, z as double and, where there is light, B_r,
/// B_g, B_b as double (radiosity, W/m²) and red, green, blue as uchar (the colour, sRGB); every face that has a corner
/// as a list, holes reached over bridges. Where faces have normals or texture coordinates, vertices are split where
/// corners differ in them and carry nx, ny, nz and s, t as double, zero at corners that have none; vertices without a
/// face are then left out. Lost, for PLY has no place for it: materials, images, objects, groups, smoothing groups.
WriteResult write_ply(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
