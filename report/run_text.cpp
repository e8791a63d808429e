#include "report/run_text.h"

#include <fmt/format.h>

namespace rad::report {

void RunText::add(std::span<const std::uint64_t> numbers) {
  ++count_;
  if (numbers.size() == 1) return add_single(numbers.front());
  flush();
  open_token();
  for (std::size_t first = 0, last = 0; first < numbers.size(); first = last + 1) {
    last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text_ += fmt::format("{}{}", first > 0 ? "+" : "", numbers[first]);
    if (last > first) text_ += fmt::format("-{}", numbers[last]);
  }
}

std::string RunText::take() {
  flush();
  return std::move(text_);
}

void RunText::add_single(std::uint64_t number) {
  if (length_ == 1 && (number == first_ || number == first_ + 1)) {
    step_ = number - first_;
    length_ = 2;
  } else if (length_ > 1 && number == first_ + step_ * length_) {
    ++length_;
  } else {
    flush();
    first_ = number;
    length_ = 1;
  }
}

void RunText::flush() {
  if (length_ == 0) return;
  open_token();
  if (length_ == 1) {
    text_ += fmt::format("{}", first_);
  } else if (step_ == 0) {
    text_ += fmt::format("{}*{}", first_, length_);
  } else {
    text_ += fmt::format("{}..{}", first_, first_ + length_ - 1);
  }
  length_ = 0;
}

void RunText::open_token() {
  if (!text_.empty()) text_ += ' ';
}

}  // namespace rad::report
