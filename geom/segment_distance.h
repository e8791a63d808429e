// Rounded distances of segments from segments and triangles.
#pragma once

#include <array>

#include "geom/vec.h"

namespace rad::geom {

using Segment = std::array<dvec3, 2>;

/// The points of two closed segments that are nearest to each other; of parallel ones some such pair.
Segment shortest_between(const Segment& a, const Segment& b);

/// The shortest way from a closed segment to a closed triangle that it does not meet: from the first to the second.
Segment shortest_between(const Segment& segment, const std::array<dvec3, 3>& triangle);

double length(const Segment& segment);

}  // namespace rad::geom
