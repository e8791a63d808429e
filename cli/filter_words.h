// From --until, --only, --skip, --mesh and --solve to the filters that run.
#pragma once

#include <string>

#include "cli/option_values.h"

namespace rad::cli {

/// Fills FixCommand::filters and partial. Returns a sentence on the first word that is wrong or on filters that need
/// another one, empty where all is right.
std::string read_filters(const FixWords& words, FixCommand& into);

}  // namespace rad::cli
