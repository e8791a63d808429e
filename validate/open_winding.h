// How well open surfaces tell inside from outside.
#pragma once

#include "validate/context.h"

namespace rad::validate {

struct Ambiguity {
  double share = 0;  ///< of the sample points: those whose winding number is more than 0.1 from a whole one
  dvec3 worst{};     ///< lattice units: the sample point that is farthest from one
};

/// At points spread over the box of the open components that are neither proved valid facades nor ground. Modulo 1 the
/// winding number of a surface is that of a cone over its rim (Stokes), so that rims are all that is summed up. Rims
/// times points are at most 2^24, but for 64 points that are always taken.
Ambiguity sample_ambiguity(const Context& context);

}  // namespace rad::validate
