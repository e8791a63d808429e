// One line on standard error that says which file is being judged.
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace rad::cli {

/// Writes nothing where `on` is false. The line is rewritten at most ten times a second and wiped at the end.
class Progress {
 public:
  Progress(std::ostream& err, bool on, std::size_t total) : err_(err), on_(on), total_(total) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The `index`-th file, from 0, is taken up.
  void show(std::size_t index, std::string_view path);

 private:
  std::ostream& err_;
  bool on_;
  std::size_t total_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace rad::cli
