// How long things take.
#pragma once

#include <chrono>
#include <ctime>

namespace rad::repair {

/// Seconds: on the wall, and of all threads of the process together.
struct Spent {
  double wall = 0;
  double cpu = 0;

  Spent& operator+=(const Spent& more) {
    wall += more.wall;
    cpu += more.cpu;
    return *this;
  }
};

class Stopwatch {
 public:
  /// What was spent since the last lap, or since it was made.
  Spent lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::clock_t cpu_now = std::clock();
    const Spent spent{std::chrono::duration<double>(now - start_).count(),
                      static_cast<double>(cpu_now - cpu_start_) / CLOCKS_PER_SEC};
    start_ = now;
    cpu_start_ = cpu_now;
    return spent;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

}  // namespace rad::repair
