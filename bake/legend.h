// The scale of a picture in false colours, beside it.
#pragma once

#include "bake/image.h"

namespace rad::bake {

/// A round number, 1, 2 or 5 times a power of ten, at or above `value`, which is above 0.
double round_above(double value);

/// The picture with a strip at its left that holds the scale of scene::false_colour(), from 0 at its foot to `most`
/// (W/m²) at its head, with numbers beside it and the unit above it. Pictures too low for it stay as they are.
Image with_legend(const Image& image, double most);

}  // namespace rad::bake
