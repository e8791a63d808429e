// The program radlint.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "cli/terminal.h"

namespace rad::cli {

/// Runs radlint with `args` (without the program's name) and returns its exit code. `out` gets the report and nothing
/// else; all else goes to `err`.
int run_radlint(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal = {});

}  // namespace rad::cli
