// Writing a scene as a plain Draco file.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes .drc: one mesh of all triangles, without loss as write_draco_glb has it. Positions are floats relative to the
/// lattice origin (or to a place near the box centre), which is metadata of the stream with pitch and tolerance:
/// "radfix.origin.x" and so on. With light, a colour in 16 bits and the radiosity (W/m²) stand beside. Lost, for the
/// format has no place for it: objects, groups, materials, texture coordinates, normals.
/// Problems: a face that triangles_of does not split; what a float cannot hold; triangles that Draco does not keep.
WriteResult write_drc(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
