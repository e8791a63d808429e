// How an aperture or door lies in the outline of its face.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace rad::readers::hbjson {

/// A corner of the outline: of the face itself, or of the part that is cut out of it.
struct OutlineCorner {
  geom::dvec3 at{0, 0, 0};
  std::optional<std::size_t> part;  ///< corner of the part; none for corners of the face
};

enum class Lie : std::uint8_t {
  Inside,   ///< a hole
  Notch,    ///< one of its edges lies on one of the outline: the outline goes round it
  Touching  ///< it meets the outline in another way: both stay as they are, one on the other
};

/// How `part` lies; distances up to `tolerance` count as none. For a notch `outline` becomes the outline around it.
Lie lie_of(std::vector<OutlineCorner>& outline, std::span<const geom::dvec3> part, double tolerance);

}  // namespace rad::readers::hbjson
