#include "solve/progress.h"

namespace rad::solve {

bool Progress::go_on(double unshot_share, std::size_t shots) {
  const Clock::time_point now = Clock::now();
  if (stopped_ || !callback_ || now < next_call_) return !stopped_;
  next_call_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / kCallsPerSecond));
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  stopped_ = !callback_({unshot_share, shots, elapsed});
  return !stopped_;
}

}  // namespace rad::solve
