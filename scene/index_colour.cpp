#include "scene/index_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rad::scene {
namespace {

constexpr std::uint32_t kWhite = 0xFFFFFF;
constexpr std::array<std::uint32_t, 10> kNamed = {kWhite,   0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF,
                                                  0x0000FF, 0xFF00FF, kWhite,   0x808080, 0xC0C0C0};
constexpr std::array<std::uint32_t, 6> kGreys = {0x333333, 0x5B5B5B, 0x848484, 0xADADAD, 0xD6D6D6, kWhite};
constexpr int kFirstGrey = 250;

// 24 hues of 15° each, from red; the last digit is the value, five steps, and with an odd one the colour is half pale.
std::uint32_t colour_of_wheel(int index) {
  constexpr std::array<double, 5> kValues = {1.0, 0.65, 0.5, 0.3, 0.15};
  const double hue = (index / 10 - 1) / 4.0;  // in sixths of the circle
  const double value = kValues[static_cast<std::size_t>(index % 10 / 2)];
  const double saturation = index % 2 == 0 ? 1.0 : 0.5;
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.0);
    const double share = std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    return static_cast<std::uint32_t>(255 * value * (1 - saturation * share));
  };
  return channel(5) << 16 | channel(3) << 8 | channel(1);
}

}  // namespace

std::uint32_t colour_of_index(int index) {
  if (index < 1 || index >= kColourByLayer) return kWhite;
  if (index < static_cast<int>(kNamed.size())) return kNamed[static_cast<std::size_t>(index)];
  if (index >= kFirstGrey) return kGreys[static_cast<std::size_t>(index - kFirstGrey)];
  return colour_of_wheel(index);
}

int nearest_index(std::uint32_t colour) {
  const auto distance = [&](int index) {
    const std::uint32_t other = colour_of_index(index);
    int sum = 0;
    for (const int shift : {16, 8, 0}) {
      const int step = static_cast<int>((colour >> shift) & 0xFF) - static_cast<int>((other >> shift) & 0xFF);
      sum += step * step;
    }
    return sum;
  };
  int nearest = 1;
  for (int index = 2; index < kColourByLayer; ++index) {
    if (distance(index) < distance(nearest)) nearest = index;
  }
  return nearest;
}

}  // namespace rad::scene
