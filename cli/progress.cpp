#include "cli/progress.h"

#include "report/text_layout.h"

namespace rad::cli {

namespace {

constexpr std::string_view kWipeLine = "\r\x1b[K";
constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

Progress::~Progress() {
  if (shown_) err_ << kWipeLine << std::flush;
}

void Progress::show(std::size_t index, std::string_view path) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ && now - last_ < kPeriod) return;
  last_ = now;
  shown_ = true;
  err_ << kWipeLine << index + 1 << '/' << total_ << ' ' << report::printable(path) << std::flush;
}

}  // namespace rad::cli
