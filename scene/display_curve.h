// From exposed light to what a display shows.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "geom/vec.h"

namespace rad::scene {

/// Of a colour that the exposure has scaled so that 1 is white.
enum class DisplayCurve : std::uint8_t {
  Linear,       ///< each channel up to 1
  Shoulder,     ///< linear below kKnee; above it the brightest channel bends towards 1, and the others with it
  Reinhard,     ///< luminance L becomes L (1 + L / kReinhardWhite²) / (1 + L) (Reinhard et al. 2002, equation 4)
  FalseColour,  ///< luminance on the scale of false_colour()
};

inline constexpr double kKnee = 0.6;
/// The least luminance that is shown as 1.
inline constexpr double kReinhardWhite = 4;

/// "linear", "shoulder", "reinhard", "falsecolor": in files and on the command line.
std::string_view name(DisplayCurve curve);

/// Luminance of linear RGB with the primaries of sRGB (ITU-R BT.709), in the unit of the channels.
double luminance(const geom::dvec3& colour);

/// Linear RGB that is shown, before what is above 1 is cut off; `exposed` has no negative channel.
geom::dvec3 curved(DisplayCurve curve, const geom::dvec3& exposed);

/// The colours of the scale at equal steps from 0 to 1, as sRGB codes 0xRRGGBB: viridis, whose lightness rises evenly
/// (van der Walt and Smith 2015).
std::span<const std::uint32_t> false_colours();

/// The scale at `value`, which is cut to 0..1; linear RGB. Between the colours of the scale sRGB codes are mixed.
geom::dvec3 false_colour(double value);

}  // namespace rad::scene
