// radfix convert: a model in another format, as it is.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "cli/options.h"

namespace rad::cli {

struct ConvertCommand {
  std::string input;
  std::string output;
  ModelOptions model;
  bool list = false;  ///< say what formats hold, and no more
};

std::variant<ConvertCommand, Stop> parse_convert(std::span<const std::string> args);

/// Reads the input and writes it without repair; what the format of the output loses is said on `out`. `args` are those
/// after "convert". Exit codes: written 0, usage, unreadable input and what cannot be written 2, no surface 4.
int run_convert(std::span<const std::string> args, std::ostream& out, std::ostream& err);

}  // namespace rad::cli
