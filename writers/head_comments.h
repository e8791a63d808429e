// The comments at the head of a file, the same in every format that has comments.
#pragma once

#include <string>
#include <vector>

#include "writers/model.h"

namespace rad::writers {

/// "radfix 0.1.0".
std::string program_name();

/// Lines without a mark of comment: the program, "radfix T=… h=… origin=… … …", "units: 0.001 m" and "up: z" where they
/// are known (readers take these back), whether the output is incomplete, and the comments of the output.
std::vector<std::string> head_comments(const Output& output);

}  // namespace rad::writers
