#include "report/text_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rad::report {

namespace {

std::string_view sequence(Ink ink) {
  switch (ink) {
    case Ink::Plain:
      return "";
    case Ink::Bold:
      return "\x1b[1m";
    case Ink::Dim:
      return "\x1b[2m";
    case Ink::Red:
      return "\x1b[1;31m";
    case Ink::Yellow:
      return "\x1b[33m";
    case Ink::Cyan:
      return "\x1b[36m";
    case Ink::Green:
      return "\x1b[32m";
  }
  return "";
}

bool continues_code_point(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string grouped_digits(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, 1, ' ');
  return digits;
}

}  // namespace

std::string Paint::operator()(Ink ink, std::string_view text) const {
  if (!on_ || ink == Ink::Plain) return std::string(text);
  return fmt::format("{}{}\x1b[0m", sequence(ink), text);
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += continues_code_point(c) ? 0 : 1;
  return count;
}

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  const std::size_t taken = columns(text);
  if (taken < width) result.append(width - taken, ' ');
  return result;
}

void append_wrapped(std::string& out, std::string_view text, std::size_t indent, std::size_t width) {
  const std::size_t room = width > indent ? width - indent : 1;
  std::size_t taken = 0;  // columns of the line that is begun
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word.empty()) continue;
    const std::size_t size = columns(word);
    if (taken > 0 && taken + 1 + size > room) {
      out += '\n';
      taken = 0;
    }
    out.append(taken == 0 ? indent : 1, ' ');
    out += word;
    taken += size + (taken > 0 ? 1 : 0);
  }
  if (taken > 0) out += '\n';
}

std::string short_number(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); }

std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural) {
  const std::string digits = grouped_digits(count);
  if (count == 1) return fmt::format("{} {}", digits, noun);
  return plural.empty() ? fmt::format("{} {}s", digits, noun) : fmt::format("{} {}", digits, plural);
}

std::string byte_size(std::uint64_t bytes) {
  constexpr std::array<std::string_view, 5> kUnits = {"bytes", "kB", "MB", "GB", "TB"};
  double size = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (size >= 1000 && unit + 1 < kUnits.size()) {
    size /= 1000;
    ++unit;
  }
  return unit == 0 ? fmt::format("{} {}", bytes, kUnits[0]) : fmt::format("{:.3g} {}", size, kUnits[unit]);
}

}  // namespace rad::report
