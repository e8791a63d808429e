// The ground of a model: a surface with nothing behind it but open space.
#pragma once

#include <span>

#include "validate/sight_lines.h"

namespace rad::validate {

enum class Ground : std::uint8_t {
  No,
  Border,       ///< flat at T, and the whole model lies in front of it or in it: proved
  HeightField,  ///< over one axis it has one height everywhere, and it reaches to the sides of the model's box
};

/// Whether the surface with these backs is ground, as far as its shape tells.
Ground ground_of(const Context& context, const LitSpace& space, std::span<const BackSide> backs);

}  // namespace rad::validate
