// What each filter promises of its result, after Table 2 of the paper.
#pragma once

#include "scene/filter.h"
#include "validate/rule.h"

namespace rad::validate {

/// Table 2 for a filter and a requirement.
enum class Cell : std::uint8_t {
  Blank,
  Required,     ///< must hold before it
  Generated,    ///< must hold after it
  PassThrough,  ///< must hold after it where it held before
};

/// The cell of Table 2; of the filters that repair, Orient generates 1b and passes the rest through. Blank for
/// requirements outside 1a to 3a, and for Solve and Bake.
Cell table_two(scene::Filter filter, Requirement requirement);

/// Whether one of the filters that repair and are not in `done` generates the requirement.
bool is_awaited(Requirement requirement, const scene::FilterSet& done);

}  // namespace rad::validate
