// A picture in linear light.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/vec.h"

namespace rad::bake {

/// Pixels by rows from the top, each row from the left; linear RGB with the primaries of sRGB, 1 is display white.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<geom::dvec3> pixels;

  [[nodiscard]] const geom::dvec3& at(std::uint32_t column, std::uint32_t row) const {
    return pixels[std::size_t{row} * width + column];
  }
};

}  // namespace rad::bake
