// How a long solve tells where it stands, and is told to stop.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace rad::solve {

struct ProgressState {
  double unshot_share = 1;  ///< of the emitted power, the worst channel
  std::size_t shots = 0;
  double elapsed_seconds = 0;
};

/// Calls back at most `kCallsPerSecond` times a second, the first time at once, and only from the thread that solves.
class Progress {
 public:
  static constexpr double kCallsPerSecond = 5;
  /// Returns false to stop the solve.
  using Callback = std::function<bool(const ProgressState&)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  /// False once the callback has asked to stop.
  bool go_on(double unshot_share, std::size_t shots);

 private:
  using Clock = std::chrono::steady_clock;

  Callback callback_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_call_ = start_;
  bool stopped_ = false;
};

}  // namespace rad::solve
