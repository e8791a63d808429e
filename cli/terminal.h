// What is known of the terminal, and when to use colour on it.
#pragma once

#include <cstddef>
#include <string>

namespace rad::cli {

enum class ColorChoice : unsigned char { Auto, Always, Never };

/// The surroundings of a run. The default is a run into files.
struct Terminal {
  bool out_is_terminal = false;
  bool err_is_terminal = false;
  std::size_t columns = 80;
  std::string force_color;  ///< environment variables by the same names; empty where unset
  std::string no_color;
  std::string clicolor_force;
  std::string term;
  std::size_t err_columns = 80;
  std::string cache_home;  ///< folder for what programs keep for later; empty where there is none
  bool alone = false;      ///< no thread but the first has been started: worker processes may be forked
};

/// Of the running process, at its start. Columns are between 40 and 120.
Terminal terminal_of_process();

/// Decided by the first that speaks: the command line, FORCE_COLOR, NO_COLOR, CLICOLOR_FORCE ("0" says nothing), and
/// then whether the report goes to a terminal that is not dumb.
bool use_color(ColorChoice choice, const Terminal& terminal);

}  // namespace rad::cli
