// Radiance scene descriptions.
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Polygons, holes reached over seams as the format has it, each with the name of its object and a number. Reflectance
/// becomes `plastic`; what emits becomes `light` of radiance M / π (W/sr/m²), luminance divided by 179 lm/W, and does
/// not reflect.
WriteResult write_rad(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
