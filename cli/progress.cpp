#include "cli/progress.h"

#include <fmt/format.h>

#include "report/text_layout.h"

namespace rad::cli {

namespace {

constexpr std::size_t kBarColumns = 24;

// The end of a path says more than its beginning.
std::string shortened(const std::string& path, std::size_t width) {
  if (report::columns(path) <= width) return path;
  std::size_t start = path.size() - std::min(path.size(), width > 1 ? width - 1 : 0);
  const auto is_continuation = [&](std::size_t at) { return at < path.size() && (path[at] & 0xC0) == 0x80; };
  while (is_continuation(start)) ++start;
  return "…" + path.substr(start);
}

std::string bar(std::size_t done, std::size_t total) {
  const std::size_t full = total == 0 ? kBarColumns : kBarColumns * done / total;
  return "[" + std::string(full, '#') + std::string(kBarColumns - full, ' ') + "]";
}

}  // namespace

void Progress::show(std::size_t done, std::string_view path) {
  const std::string count = fmt::format("{0:>{2}}/{1}", done, total_, fmt::formatted_size("{}", total_));
  const std::string head = total_ > 1 ? fmt::format("{} {} ", bar(done, total_), count) : std::string("judging ");
  const std::size_t left = columns_ > head.size() + 1 ? columns_ - head.size() - 1 : 0;
  line_.show(head + shortened(report::printable(path), left));
}

}  // namespace rad::cli
