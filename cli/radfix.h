// The program radfix.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "cli/terminal.h"

namespace rad::cli {

/// Runs radfix with `args` (without the program's name) and returns its exit code. This version repairs nothing: a
/// model without errors at stage model is written unchanged and judged again as written, any other is refused.
int run_radfix(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal = {});

}  // namespace rad::cli
