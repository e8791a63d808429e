// Words and commands of a Radiance scene description.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rad::readers::radiance {

/// Blank-separated words; one that begins with a quote ends with the same quote and may hold blanks. '#' at the start
/// of a word hides the rest of the line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word, without its quotes; empty at the end of the text.
  std::string_view next();
  /// Whether the next word begins a line "!command".
  bool at_command();
  /// That line without the '!'; a backslash at its end joins the next one to it.
  std::string command();
  /// 1-based line of the word or command given last.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] std::uint64_t bytes_left() const { return text_.size() - at_; }
  /// Whether the text has been read to its end.
  [[nodiscard]] bool at_end();

 private:
  void skip_blanks();
  void skip_line();

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
  std::uint64_t next_line_ = 1;
};

}  // namespace rad::readers::radiance
