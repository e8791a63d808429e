// The thin features of an input, which radfix lists before it welds anything.
#pragma once

#include <vector>

#include "report/report.h"

namespace rad::report {

/// Findings of RL107 in their order, then those that are suppressed: to weld loses them all the same.
std::vector<scene::Finding> thin_features(const InputReport& input);

}  // namespace rad::report
