// The faces of a judged model as the soup that repair starts from.
#pragma once

#include "repair/soup.h"
#include "validate/context.h"

namespace rad::repair {

/// `ranks` holds for each face the place of its surface among those that may hide each other (SurfaceOrder).
/// Triangles of the sound faces; the rings of faces whose rings cross, which the plane maps will cut into what an odd
/// number of rings encloses. Faces without area and faces with corners that are not finite have no piece. The order of
/// pieces follows their places in space, not the order of faces.
Soup input_soup(const validate::Context& context, std::span<const std::uint32_t> ranks);

}  // namespace rad::repair
