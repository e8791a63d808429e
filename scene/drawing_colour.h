// Colours of drawings, in sRGB, as reflectances, and back.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/vec.h"

namespace rad::scene {

/// What the white of a drawing reflects: a colour on a screen says how bright a surface is beside white paint, which
/// reflects about four fifths of the light, and not that it reflects everything.
inline constexpr double kWhitePaint = 0.8;

/// An sRGB value of 0..1 as a linear one, and back (IEC 61966-2-1).
inline double linear_of_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
inline double srgb_of_linear(double value) {
  return value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

/// The reflectance of a colour in sRGB, 0..1 for each channel.
inline geom::dvec3 reflectance_of_srgb(const geom::dvec3& colour) {
  const auto channel = [](double value) { return kWhitePaint * linear_of_srgb(std::clamp(value, 0.0, 1.0)); };
  return {channel(colour.x), channel(colour.y), channel(colour.z)};
}

/// The reflectance of a colour 0xRRGGBB.
inline geom::dvec3 reflectance_of_colour(std::uint32_t colour) {
  const auto channel = [&](int shift) { return ((colour >> shift) & 0xFF) / 255.0; };
  return reflectance_of_srgb({channel(16), channel(8), channel(0)});
}

/// The colour of a reflectance in sRGB; what white paint outshines is white.
inline geom::dvec3 srgb_of_reflectance(const geom::dvec3& reflectance) {
  const auto channel = [](double value) { return srgb_of_linear(std::clamp(value / kWhitePaint, 0.0, 1.0)); };
  return {channel(reflectance.x), channel(reflectance.y), channel(reflectance.z)};
}

/// The same as 0xRRGGBB.
inline std::uint32_t colour_of_reflectance(const geom::dvec3& reflectance) {
  const geom::dvec3 colour = srgb_of_reflectance(reflectance);
  const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(value * 255)); };
  return byte(colour.x) << 16 | byte(colour.y) << 8 | byte(colour.z);
}

}  // namespace rad::scene
