#include "cli/live_line.h"

#include <csignal>

namespace rad::cli {

namespace {

constexpr std::string_view kWipeLine = "\r\x1b[K";
constexpr std::chrono::milliseconds kPeriod{100};

volatile std::sig_atomic_t interrupt_seen = 0;

void note_interrupt(int signal) {
  interrupt_seen = 1;
  std::signal(signal, SIG_DFL);
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
