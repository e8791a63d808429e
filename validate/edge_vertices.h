// T-vertices and cracks, told apart as the rules of 2a and 3a need them.
#pragma once

#include "validate/context.h"
#include "validate/rule.h"

namespace rad::validate {

/// A violation for every vertex inside an edge that it does not belong to: those where a face at the vertex and a face
/// at the edge are of one surface if `within_surface`, else the others. Left out where only faces that are back to back
/// meet. Measure: distance from the edge, file units.
void report_t_vertices(const Context& context, bool within_surface, Violations& out);

/// Whether the faces look opposite ways, within 2.6°. Of faces that touch: whether they lie on each other unseen.
bool back_to_back(const Context& context, FaceId a, FaceId b);

}  // namespace rad::validate
