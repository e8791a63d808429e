// `radlint diff`: two judgements compared.
#pragma once

#include <ostream>

#include "cli/options.h"

namespace rad::cli {

/// Reads or judges both sides, writes the comparison and returns the exit code: 1 where something is new or worse at or
/// above --fail-on, else 3 where a side says less than all.
int run_diff(const DiffCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal);

}  // namespace rad::cli
