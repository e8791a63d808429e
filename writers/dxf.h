// DXF as text, of the sort that every program reads (R12).
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// A 3DFACE for each triangle or quad, on a layer for each object, in the colour of the index nearest to its
/// reflectance. $INSUNITS where the unit is known.
WriteResult write_dxf(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
