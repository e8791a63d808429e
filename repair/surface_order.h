// Which surface is visible where several overlap: one total order of all surfaces, so that any number of layers and any
// partial overlaps come out the same way (paper 3.3: the face from the larger surface is removed).
#pragma once

#include <vector>

#include "validate/context.h"

namespace rad::repair {

/// Per face its surface's place in the order; the least is visible. Emitters before others, then the smaller area
/// (areas within about 0.1 % count as equal), then the names of material and object, then the place in space.
std::vector<std::uint32_t> surface_ranks(const validate::Context& context);

}  // namespace rad::repair
