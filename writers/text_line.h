// Pieces of a line of text.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace rad::writers {

/// Appends the shortest decimal that reads back the same.
template <typename Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

/// Text that stays on its line: no control characters, and no backslash at the end, which continues a line of OBJ.
std::string one_line(std::string_view text);

}  // namespace rad::writers
