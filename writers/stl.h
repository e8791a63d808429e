// Writing a scene as STL.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes binary STL; convex quads are split, larger faces are a problem. Coordinates become floats: a vertex moves by
/// up to half a unit in the last place, and one that a float cannot hold at all is a problem. Lost, for STL has no
/// place for it: the sharing of vertices, materials, objects, groups, light, lattice, comments.
WriteResult write_stl(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
