// Which build of the program is running.
#pragma once

#include <string>

namespace rad::batch {

/// The build ids of the program and of the libraries that it has loaded; where it carries none, a digest of its file.
/// Changes with every change of code.
std::string tool_identity();

}  // namespace rad::batch
