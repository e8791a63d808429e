// Identity of a finding across renumbering, shuffling and re-export.
#pragma once

#include <string>

#include "scene/finding.h"
#include "validate/context.h"

namespace rad::validate {

/// Sixteen hex digits over the rule, the names of objects and materials that take part, and the place relative to the
/// low corner of the first object's box in steps of 64 T, so that noise and moving the object as a whole keep it.
/// Steps have borders: matching across reports compares places too (algorithms: tiers).
std::string fingerprint_of(const scene::Finding& finding, const dvec3& frame_origin, double tolerance);

}  // namespace rad::validate
