// Rectangles of whole texels on a page.
#pragma once

#include <cstdint>
#include <span>

namespace rad::bake {

/// `x` and `y` are of the upper left corner, once placed.
struct PackedRectangle {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  bool placed = false;
};

/// Places as many of the rectangles as find room, none over another, and marks them. The same for the same rectangles
/// in the same order. Sides are above 0 and at most 2^20.
void pack_rectangles(std::span<PackedRectangle> rectangles, std::uint32_t page_width, std::uint32_t page_height);

}  // namespace rad::bake
