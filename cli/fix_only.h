// --fix-only: from rules to the filters that cure them.
#pragma once

#include <span>
#include <string>

#include "cli/options.h"
#include "report/report.h"

namespace rad::cli {

/// Replaces the filters of repair by those that cure the rules of --fix-only. Returns why one of the rules cannot be
/// cured in this way, empty where all can.
std::string choose_filters_for_rules(FixCommand& command);

/// Errors `found` in the input that the filters would cure as well though they are not named: then the rules cannot be
/// cured alone. Empty where there are none.
std::string inseparable_rules(const FixCommand& command, std::span<const scene::Finding> found);

}  // namespace rad::cli
