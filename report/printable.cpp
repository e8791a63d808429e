#include "report/printable.h"

#include <algorithm>
#include <cstdint>

#include "scene/utf8.h"

namespace rad::report {

namespace {

bool is_blank(char32_t point) {
  return point == '\t' || point == '\n' || point == '\r' || point == 0x2028 || point == 0x2029;
}

bool is_fit(char32_t point) {
  if (point < 0x20 || (point >= 0x7F && point < 0xA0)) return false;
  if (point == 0x061C || point == 0x200E || point == 0x200F || point == 0xFEFF) return false;
  if ((point >= 0x202A && point <= 0x202E) || (point >= 0x2066 && point <= 0x2069)) return false;
  return (point & 0xFFFEu) != 0xFFFE && point < scene::Utf8Character::kNone;
}

bool is_plain(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7F; });
}

}  // namespace

std::string printable(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const scene::Utf8Character next = scene::first_character(text);
    if (is_blank(next.point)) {
      out += ' ';
    } else if (is_fit(next.point)) {
      out += text.substr(0, next.bytes);
    } else {
      out += "\xEF\xBF\xBD";
    }
    text.remove_prefix(next.bytes);
  }
  return out;
}

std::string with_backslashes(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string shortened(std::string text, std::size_t bytes) {
  constexpr std::string_view kDots = "…";
  if (text.size() <= bytes) return text;
  std::size_t end = bytes > kDots.size() ? bytes - kDots.size() : 0;
  while (end > 0 && (static_cast<std::uint8_t>(text[end]) & 0xC0u) == 0x80) --end;
  text.resize(end);
  return text += kDots;
}

}  // namespace rad::report
