// What can be wrong with the files that radfix is to read and write, found before a long run rather than after it.
#pragma once

#include <string>

#include "cli/options.h"

namespace rad::cli {

/// A sentence on the first path that cannot be used, empty where all can. The input must be a file; the output must
/// have a format that is written; output, preview and report need a folder that exists, and none may be the input or
/// another of them.
std::string fix_path_problem(const FixCommand& command);

}  // namespace rad::cli
