// CityJSON 2.0.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// A city object for each object of the scene, with its faces and their holes as MultiSurface of level of detail 2.
/// Groups that are names of semantic surfaces become those. Vertices are whole numbers of the lattice of the run, or of
/// one as fine as doubles are at the model's size; unit and up axis go into the transform, so that the file is in
/// metres with Z up.
WriteResult write_cityjson(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
