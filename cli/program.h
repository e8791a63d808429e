// What the main functions of both programs share.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "cli/terminal.h"

namespace rad::cli {

using Run = int (*)(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal);

/// Runs `run` on the process's arguments and streams. A reader that closes the pipe does not kill the process, and
/// whatever is thrown becomes one line on standard error and exit code 2.
int run_program(const char* name, Run run, int argc, char** argv);

}  // namespace rad::cli
