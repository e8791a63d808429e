// Light maps as OpenEXR.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace rad::bake {

enum class ExrPrecision : std::uint8_t { Half, Float };

/// The least of which every value that is not zero keeps its eleven bits: half from its least normal number, 2^-14, to
/// its largest, 65504. `least` and `most` are those of all values above 0; half where there are none.
ExrPrecision precision_for(double least, double most);

struct ExrPicture {
  std::uint32_t width = 0;  ///< above 0
  std::uint32_t height = 0;
  std::span<const float> rgb;       ///< three for each texel, by rows from the top; finite
  std::span<const float> coverage;  ///< 0..1
  ExrPrecision precision = ExrPrecision::Half;
};

/// What stands in the header beside the chromaticities, those of sRGB (ITU-R BT.709, D65).
struct ExrHeader {
  std::string quantity;  ///< "radiant exitance" or "irradiance"
  std::string units;     ///< "W/m2"
  std::string software;
  std::string comments;
  std::optional<double> white_luminance;  ///< cd/m² of R = G = B = 1
};

/// The bytes of a file with scan lines under ZIP compression: channels R, G and B in the precision, and `coverage` in
/// half. It is not called A: by OpenEXR's rule readers would divide by it, and the gutter, where it is 0, would go
/// dark.
std::string exr_bytes(const ExrPicture& picture, const ExrHeader& header);

}  // namespace rad::bake
