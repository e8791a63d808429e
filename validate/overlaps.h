// Pairs of coplanar faces that overlap, told apart as the rules of 2c need them.
#pragma once

#include "validate/context.h"
#include "validate/rule.h"

namespace rad::validate {

enum class OverlapKind : std::uint8_t {
  SameMaterial,       ///< same facing, same material: RL220
  DifferentMaterial,  ///< same facing, different materials: RL221
  Twin,               ///< opposite facing, same corners, material and object: RL114
  Hidden,             ///< opposite facing otherwise: RL222
};

/// A violation for every overlap of the kind; measure is the overlapping area in file units².
void report_overlaps(const Context& context, OverlapKind kind, Violations& out);

}  // namespace rad::validate
