// Baselines of radlint: --baseline, --write-baseline, --prune-baseline, --strict-baseline.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/options.h"

namespace rad::cli {

/// What is wrong with the options taken together; empty for nothing.
std::string baseline_fault(const BaselineChoice& choice);

/// Takes what the baseline of the command knows out of the findings of `report`, writes and prunes baselines as asked,
/// and adds RL904 for what does not occur any more. Returns what went wrong, empty for nothing.
/// `stale_severity` gives what RL904 weighs for an input, nothing where it is not asked for.
std::string use_baseline(const LintCommand& command, report::Report& report,
                         const std::function<std::optional<scene::Severity>(const std::string&)>& stale_severity);

}  // namespace rad::cli
