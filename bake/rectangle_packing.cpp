#include "bake/rectangle_packing.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

// The sort of the C library may leave equal rectangles in any order.
template <typename Rectangle>
void sort_stably(Rectangle* first, int count, std::size_t, int (*compare)(const void*, const void*)) {
  std::stable_sort(first, first + count,
                   [compare](const Rectangle& a, const Rectangle& b) { return compare(&a, &b) < 0; });
}

}  // namespace

#define STBRP_SORT sort_stably
#define STBRP_STATIC
#define STB_RECT_PACK_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_rect_pack.h>
#pragma GCC diagnostic pop

namespace rad::bake {

void pack_rectangles(std::span<PackedRectangle> rectangles, std::uint32_t page_width, std::uint32_t page_height) {
  std::vector<stbrp_rect> packed;
  packed.reserve(rectangles.size());
  for (const PackedRectangle& rectangle : rectangles) {
    packed.push_back({0, static_cast<int>(rectangle.width), static_cast<int>(rectangle.height), 0, 0, 0});
  }
  // As many nodes as columns, or the packer may lack one where there is room.
  std::vector<stbrp_node> nodes(page_width);
  stbrp_context context;
  stbrp_init_target(&context, static_cast<int>(page_width), static_cast<int>(page_height), nodes.data(),
                    static_cast<int>(nodes.size()));
  stbrp_pack_rects(&context, packed.data(), static_cast<int>(packed.size()));
  for (std::size_t i = 0; i < packed.size(); ++i) {
    rectangles[i].placed = packed[i].was_packed != 0;
    if (!rectangles[i].placed) continue;
    rectangles[i].x = static_cast<std::uint32_t>(packed[i].x);
    rectangles[i].y = static_cast<std::uint32_t>(packed[i].y);
  }
}

}  // namespace rad::bake
