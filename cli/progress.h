// One line on standard error that says which file is being judged.
#pragma once

#include <cstddef>
#include <ostream>
#include <string_view>

#include "cli/live_line.h"

namespace rad::cli {

class Progress {
 public:
  Progress(std::ostream& err, bool on, std::size_t total) : line_(err, on), total_(total) {}

  /// The `index`-th file, from 0, is taken up.
  void show(std::size_t index, std::string_view path);

 private:
  LiveLine line_;
  std::size_t total_;
};

}  // namespace rad::cli
