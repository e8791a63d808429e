// The colour index of AutoCAD (ACI).
#pragma once

#include <cstdint>

namespace rad::readers::dxf {

inline constexpr int kByBlock = 0;
inline constexpr int kByLayer = 256;

/// 0xRRGGBB of an index from 1 to 255; white for others.
std::uint32_t colour_of_index(int index);

}  // namespace rad::readers::dxf
