#include "bake/srgb_codes.h"

#include <algorithm>
#include <bit>

#include "bake/png.h"

namespace rad::bake {
namespace {

// Floats from 0 on are in the order of their bits.
float least_with(std::uint8_t code) {
  std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(1.0f);
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (srgb_code(std::bit_cast<float>(middle)) >= code) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<float>(low);
}

}  // namespace

SrgbCodes::SrgbCodes() {
  for (std::size_t code = 0; code < least_.size(); ++code) least_[code] = least_with(static_cast<std::uint8_t>(code));
}

std::uint8_t SrgbCodes::of(float linear) const {
  const auto above = std::upper_bound(least_.begin() + 1, least_.end(), linear);
  return static_cast<std::uint8_t>(above - least_.begin() - 1);
}

}  // namespace rad::bake
