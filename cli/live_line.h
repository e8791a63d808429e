// One line on standard error that says what is going on; and the stop that a user asks for with Ctrl-C.
#pragma once

#include <chrono>
#include <ostream>
#include <string_view>

namespace rad::cli {

/// Writes nothing where `on` is false. The line is rewritten at most ten times a second and wiped at the end.
class LiveLine {
 public:
  LiveLine(std::ostream& err, bool on) : err_(err), on_(on) {}
  ~LiveLine() { wipe(); }
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

  void show(std::string_view text);
  void wipe();

 private:
  std::ostream& err_;
  bool on_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// While it lives, the first interrupt (Ctrl-C, SIGTERM) is noted and the second ends the process as usual.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  [[nodiscard]] bool interrupted() const;
};

}  // namespace rad::cli
