// Text of unknown origin, character by character.
#pragma once

#include <cstddef>
#include <string_view>

namespace rad::scene {

/// The first character of a text.
struct Utf8Character {
  static constexpr char32_t kNone = 0x110000;
  char32_t point = kNone;  ///< kNone: no character starts here
  std::size_t bytes = 1;   ///< those it takes; 1 where there is none
};

/// By the table of well-formed byte sequences (Unicode, 3.9): no overlong forms, no surrogates. `text` is not empty.
Utf8Character first_character(std::string_view text);

}  // namespace rad::scene
