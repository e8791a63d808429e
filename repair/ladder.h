// The escalation ladder: where the work at T does not end clean it goes on at a little more, while lint stays at T.
#pragma once

#include "repair/conform.h"

namespace rad::repair {

/// Conforms the soup at T. What is left then is worked on alone, at growing multiples of T; where that does not help
/// all starts again from the soup at such a multiple. The first result that is clean, or the one that leaves the least.
/// `tolerance` is T in pitches. Counts are of everything that led to the result.
Conformed climb(const Soup& soup, std::int64_t tolerance, const ConformProgress& progress);

}  // namespace rad::repair
