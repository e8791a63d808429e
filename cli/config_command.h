// `radlint config`: what is in force, and from where.
#pragma once

#include <ostream>

#include "cli/options.h"

namespace rad::cli {

/// Writes the settings of the model or folder that the command names. Throws config::ConfigFault where a file of
/// configuration is not understood. Returns the exit code.
int run_config(const ConfigCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rad::cli
