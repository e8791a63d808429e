// Pairs of faces that the Grouper would merge into one maximal planar face.
#pragma once

#include "validate/context.h"

namespace rad::validate {

/// Whether the two faces are of one object and material, look the same way and lie within T of the larger one's plane.
bool coplanar_within_tolerance(const Context& context, FaceId a, FaceId b);

/// Whether a third face meets one of the two faces on the subedge: its outline has to stay where it is.
bool contact_on_subedge(const Context& context, const Subedge& subedge, FaceId a, FaceId b);

}  // namespace rad::validate
