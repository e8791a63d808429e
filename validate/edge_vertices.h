// T-vertices and cracks, told apart as the rules of 2a and 3a need them.
#pragma once

#include "validate/context.h"
#include "validate/rule.h"

namespace rad::validate {

/// A violation for every vertex inside an edge that it does not belong to: those where a face at the vertex and a face
/// at the edge are of one surface if `within_surface`, else the others. Measure: distance from the edge, file units.
void report_t_vertices(const Context& context, bool within_surface, Violations& out);

}  // namespace rad::validate
