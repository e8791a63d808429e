// `radlint rule ID` and `radlint rules`.
#pragma once

#include <ostream>

#include "cli/options.h"

namespace rad::cli {

/// Writes one page or the list of all rules; an unknown rule is a usage error with a suggestion.
int run_rule_pages(const RuleCommand& command, std::ostream& out, std::ostream& err, std::size_t width);

}  // namespace rad::cli
