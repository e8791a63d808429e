// Many linear values to code values of sRGB.
#pragma once

#include <array>
#include <cstdint>

namespace rad::bake {

/// The same as srgb_code(), faster for many floats.
class SrgbCodes {
 public:
  SrgbCodes();
  [[nodiscard]] std::uint8_t of(float linear) const;

 private:
  std::array<float, 256> least_{};  ///< the least float with each code or a higher one
};

}  // namespace rad::bake
