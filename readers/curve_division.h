// How readers divide circles into chords.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace rad::readers {

/// Chords of a full circle. A chord is at most (1 - cos(π/24)) r = 0.86 % of the radius away from its arc.
inline constexpr std::uint32_t kChordsOfCircle = 24;

/// Chords of an arc of this angle in radians, at least one, none longer than that of a full circle.
inline std::uint32_t chords_of_arc(double angle) {
  const double chords = std::ceil(std::abs(angle) / (2 * std::numbers::pi) * kChordsOfCircle - 1e-9);
  return chords >= 1 && chords <= kChordsOfCircle ? static_cast<std::uint32_t>(chords)
         : chords >= 1                            ? kChordsOfCircle
                                                  : 1;
}

}  // namespace rad::readers
