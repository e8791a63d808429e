// Which findings of an input a report lists one by one.
#pragma once

#include <vector>

#include "report/report.h"

namespace rad::report {

/// The findings of `input` in canonical order, of each rule at most `max_issues` (0 for all): no rule that occurs is
/// hidden. They live as long as the input.
std::vector<const scene::Finding*> listed_findings(const InputReport& input, std::size_t max_issues);

}  // namespace rad::report
