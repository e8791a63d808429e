#include "cli/live_line.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace rad::cli {

namespace {

constexpr std::string_view kWipeLine = "\r\x1b[K";
constexpr std::chrono::milliseconds kPeriod{100};

// `timeout` signals a process and then its whole group, so that one interrupt arrives twice: what follows so soon is the
// same interrupt, and only a later one means that the user will not wait.
constexpr std::int64_t kSameInterruptNanoseconds = 500'000'000;

volatile std::sig_atomic_t interrupt_seen = 0;
std::atomic<std::int64_t> first_interrupt{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "signal handlers may not lock");

std::int64_t monotonic_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // unlike std::chrono, named by POSIX as safe in a handler
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void note_interrupt(int signal) {
  const std::int64_t now = monotonic_nanoseconds();
  if (interrupt_seen != 0 && now - first_interrupt.load() > kSameInterruptNanoseconds) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  if (interrupt_seen == 0) first_interrupt = now;
  interrupt_seen = 1;
}

}  // namespace

void LiveLine::show(std::string_view text) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && now - last_ < kPeriod) return;
  last_ = now;
  shown_ = true;
  err_ << kWipeLine << text << std::flush;
}

void LiveLine::wipe() {
  if (shown_) err_ << kWipeLine << std::flush;
  shown_ = false;
}

InterruptWatch::InterruptWatch() {
  interrupt_seen = 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptWatch::interrupted() const { return interrupt_seen != 0; }

}  // namespace rad::cli
