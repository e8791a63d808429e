// A bar on standard error that says how many files are judged.
#pragma once

#include <cstddef>
#include <ostream>
#include <string_view>

#include "cli/live_line.h"

namespace rad::cli {

class Progress {
 public:
  /// `columns` are those of the terminal; without one nothing is shown.
  Progress(std::ostream& err, bool on, std::size_t columns, std::size_t total)
      : line_(err, on), columns_(columns), total_(total) {}

  /// `done` files are judged; `path` is the last of them, or the one being judged.
  void show(std::size_t done, std::string_view path);

 private:
  LiveLine line_;
  std::size_t columns_;
  std::size_t total_;
};

}  // namespace rad::cli
