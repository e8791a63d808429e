// Pictures as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "bake/image.h"

namespace rad::bake {

/// Code value of one linear channel in sRGB (IEC 61966-2-1), 0 to 255, rounded to the nearest; values outside 0..1 are
/// clamped.
std::uint8_t srgb_code(double linear);

/// The bytes of a PNG file: 8-bit RGB, marked as sRGB, without any other text or time. Empty for a picture without
/// pixels.
std::string png_bytes(const Image& image);

/// The same of code values of sRGB: red, green and blue of each pixel, by rows of `width` pixels from the top.
std::string png_bytes(std::uint32_t width, std::span<const std::uint8_t> codes);

}  // namespace rad::bake
