// The colour index of AutoCAD (ACI), which drawings and writers of drawings share.
#pragma once

#include <cstdint>

namespace rad::scene {

inline constexpr int kColourByBlock = 0;
inline constexpr int kColourByLayer = 256;

/// 0xRRGGBB of an index from 1 to 255; white for others.
std::uint32_t colour_of_index(int index);

/// The index from 1 to 255 whose colour is nearest to 0xRRGGBB; the lowest of equal ones.
int nearest_index(std::uint32_t colour);

}  // namespace rad::scene
