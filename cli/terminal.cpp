#include "cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace rad::cli {

namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

// After the XDG Base Directory Specification, which has relative paths passed over.
std::string cache_home() {
  if (const std::string home = environment("XDG_CACHE_HOME"); home.starts_with('/')) return home;
  const std::string home = environment("HOME");
  return home.starts_with('/') ? home + "/.cache" : std::string();
}

std::size_t columns_of(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::clamp<std::size_t>(size.ws_col, 40, 120);
}

bool asks(const std::string& value) { return !value.empty() && value != "0"; }

}  // namespace

Terminal terminal_of_process() {
  Terminal terminal;
  terminal.out_is_terminal = isatty(STDOUT_FILENO) == 1;
  terminal.err_is_terminal = isatty(STDERR_FILENO) == 1;
  if (terminal.out_is_terminal) terminal.columns = columns_of(STDOUT_FILENO);
  terminal.force_color = environment("FORCE_COLOR");
  terminal.no_color = environment("NO_COLOR");
  terminal.clicolor_force = environment("CLICOLOR_FORCE");
  terminal.term = environment("TERM");
  if (terminal.err_is_terminal) terminal.err_columns = columns_of(STDERR_FILENO);
  terminal.cache_home = cache_home();
  terminal.alone = true;
  return terminal;
}

bool use_color(ColorChoice choice, const Terminal& terminal) {
  if (choice != ColorChoice::Auto) return choice == ColorChoice::Always;
  if (asks(terminal.force_color)) return true;
  if (!terminal.no_color.empty()) return false;
  if (asks(terminal.clicolor_force)) return true;
  return terminal.out_is_terminal && terminal.term != "dumb";
}

}  // namespace rad::cli
