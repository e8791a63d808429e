#include "config/toml_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rad::config {

namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// Behind the string that begins at `at` with a quote; an unclosed one on a single line ends with the line.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = text.substr(at, 3);
  const bool many_lines = three.size() == 3 && three[1] == quote && three[2] == quote;
  std::size_t i = at + (many_lines ? 3 : 1);
  while (i < text.size()) {
    if (text[i] == '\\' && quote == '"') {
      i += 2;
    } else if (many_lines && text.substr(i, 3) == three) {
      return i + 3;
    } else if (!many_lines && (text[i] == quote || text[i] == '\n')) {
      return text[i] == quote ? i + 1 : i;
    } else {
      ++i;
    }
  }
  return text.size();
}

class AsciiWriter {
 public:
  AsciiWriter(std::string_view text, int most_dots) : text_(text), most_dots_(most_dots) {}

  AsciiToml run() {
    std::size_t at = 0;
    while (at < text_.size() && result_.line == 0) at = take(at);
    return std::move(result_);
  }

 private:
  /// Takes over what begins at `at`; gives where it ends.
  std::size_t take(std::size_t at) {
    const char c = text_[at];
    if (c == '"' || c == '\'') return take_string(at, behind_string(text_, at));
    if (c == '#') return take_comment(at, std::min(text_.find('\n', at), text_.size()));
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
    if (c == '.' && ++dots_ > most_dots_) refuse(at, fmt::format("a name of more than {} parts", most_dots_));
    if (!is_ascii(c)) refuse(at, "a letter that is not ASCII belongs into quotes");
    result_.text += c;
    return at + 1;
  }

  std::size_t take_string(std::size_t at, std::size_t end) {
    for (const char c : text_.substr(at, end - at)) {
      if (is_ascii(c) && c != '%') {
        result_.text += c;
      } else {
        result_.text += fmt::format("%{:02X}", static_cast<unsigned char>(c));
      }
    }
    return end;
  }

  std::size_t take_comment(std::size_t at, std::size_t end) {
    for (const char c : text_.substr(at, end - at)) result_.text += is_ascii(c) ? c : '?';
    return end;
  }

  void refuse(std::size_t at, std::string fault) {
    result_.line = 1 + static_cast<std::uint64_t>(std::ranges::count(text_.substr(0, at), '\n'));
    result_.fault = std::move(fault);
  }

  std::string_view text_;
  int most_dots_;
  int dots_ = 0;
  AsciiToml result_;
};

}  // namespace

AsciiToml ascii_toml(std::string_view text, int most_dots) { return AsciiWriter(text, most_dots).run(); }

std::string plain_text(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const char* const end = digits.data() + digits.size();
    const bool coded = text[i] == '%' && digits.size() == 2 && std::from_chars(digits.data(), end, byte, 16).ptr == end;
    plain += coded ? static_cast<char>(byte) : text[i];
    if (coded) i += 2;
  }
  return plain;
}

}  // namespace rad::config
