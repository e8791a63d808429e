// The ground of a model: a surface with nothing behind it but open space.
#pragma once

#include <span>

#include "validate/sight_lines.h"

namespace rad::validate {

enum class GroundShape : std::uint8_t {
  None,
  Border,       ///< flat at T, and the whole model lies in front of it or in it: proved
  HeightField,  ///< over one axis it has one height everywhere, and it reaches to the sides of the model's box
};

struct Ground {
  GroundShape shape = GroundShape::None;
  int axis = 0;             ///< of a height field
  bool up = true;           ///< its front looks along the axis
  std::int32_t lowest = 0;  ///< where it lies farthest back along the axis

  /// Whether the component reaches in front of the height field: what of it is seen from behind is sunk into the
  /// ground.
  [[nodiscard]] bool is_pierced_by(const Component& component) const;
};

/// Whether the surface with these backs is ground, as far as its shape tells.
Ground ground_of(const Context& context, const LitSpace& space, std::span<const BackSide> backs);

}  // namespace rad::validate
