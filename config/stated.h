// Values with the place where they were stated.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace rad::config {

/// Where a setting comes from: a line of a file, an option of the command line ("--stage"), or nowhere.
struct Origin {
  std::string source;      ///< path or option; empty: the standard value
  std::uint64_t line = 0;  ///< 1-based, 0 where there is none

  /// "radlint.toml:3", "--stage", "default"
  [[nodiscard]] std::string text() const {
    if (source.empty()) return "default";
    return line > 0 ? source + ":" + std::to_string(line) : source;
  }
};

template <typename T>
struct Stated {
  T value;
  Origin origin{};
};

}  // namespace rad::config
