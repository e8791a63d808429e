// Baselines of radlint: --baseline, --write-baseline, --prune-baseline, --strict-baseline.
#pragma once

#include <string>

#include "cli/options.h"

namespace rad::cli {

/// What is wrong with the options taken together; empty for nothing.
std::string baseline_fault(const BaselineChoice& choice);

/// Takes what the baseline of the command knows out of the findings of `report`, writes and prunes baselines as asked,
/// and adds RL904 for what does not occur any more. Returns what went wrong, empty for nothing.
std::string use_baseline(const LintCommand& command, report::Report& report);

}  // namespace rad::cli
