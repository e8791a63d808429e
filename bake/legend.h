// The scale of a picture in false colours, drawn into it.
#pragma once

#include "bake/image.h"

namespace rad::bake {

/// A round number, 1, 2 or 5 times a power of ten, at or above `value`, which is above 0.
double round_above(double value);

/// Draws the scale of scene::false_colour() along the left side, from 0 at its foot to `most` (W/m²) at its head, with
/// numbers beside it and the unit above it. Pictures too small for it stay as they are.
void draw_legend(Image& image, double most);

}  // namespace rad::bake
