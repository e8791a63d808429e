// A cursor over the lines and blank-separated tokens of a text format. It takes no memory for each line.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rad::readers {

/// The number that a whole token spells, whatever the locale: decimal, with an optional sign on either side of zero,
/// "nan" and "inf" in any case, and the spellings "1.#INF", "1.#IND", "1.#QNAN" of older C libraries. Too large a
/// number is infinite, too small a one zero. Nothing where the token is not a number.
std::optional<double> parse_number(std::string_view token);

/// The whole number that a token spells; one beyond 64 bits becomes the nearest that fits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// A token as a message shows it: in quotes, cut to at most 40 bytes, with '?' for control characters and what is not UTF-8.
std::string in_quotes(std::string_view token);

/// Text without the mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// Lines end with LF, CR LF or a lone CR. Blanks are space, tab, vertical tab and form feed; '#' at the start of a
/// token hides the rest of the line. Views that are handed out stay valid as long as the text does, those of rest()
/// until the next call of rest().
class TextCursor {
 public:
  /// Whether a backslash at the end of a line joins the next line to it.
  enum class Continuation : std::uint8_t { None, Backslash };
  enum class Token : std::uint8_t { Absent, Good, Bad };

  explicit TextCursor(std::string_view text, std::uint64_t line_limit = std::numeric_limits<std::uint64_t>::max(),
                      Continuation continuation = Continuation::None);

  /// Steps to the first line, then to the next. False at the end, and after a line beyond the limit of bytes.
  bool next_line();

  /// 1-based number of the line that the current logical line starts on; 0 before the first.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] bool passed_line_limit() const { return passed_line_limit_; }

  /// The next token of the line; empty at its end.
  std::string_view next_token();

  /// Reads the next token as a number. A bad one is stepped over and kept in bad_token(), `value` is then unchanged.
  Token next_number(double& value);
  Token next_integer(std::int64_t& value);
  [[nodiscard]] std::string_view bad_token() const { return bad_token_; }

  /// Whether next_token() has stopped at a '#'.
  [[nodiscard]] bool at_comment() const { return at_ != end_ && *at_ == '#'; }

  /// What is left of the line, without blanks around it; '#' is an ordinary character here.
  std::string_view rest();

  /// Bytes from the current place to the end of the text.
  [[nodiscard]] std::uint64_t bytes_left() const { return static_cast<std::uint64_t>(end_ - at_); }
  /// Bytes of the text before the current place.
  [[nodiscard]] std::uint64_t offset() const { return static_cast<std::uint64_t>(at_ - begin_); }

 private:
  [[nodiscard]] const char* after_line_end(const char* at) const;
  [[nodiscard]] bool continues_at(const char* at) const;
  [[nodiscard]] bool ends_token(const char* at) const;
  [[nodiscard]] bool at_line_end() const;
  void skip_blanks();
  void skip_line();
  void step_over_line_end();
  const char* token_end() const;

  const char* begin_;
  const char* at_;
  const char* end_;
  const char* line_start_;
  std::uint64_t line_limit_;
  std::uint64_t line_ = 0;
  std::uint64_t line_ends_passed_ = 0;
  Continuation continuation_;
  bool started_ = false;
  bool passed_line_limit_ = false;
  std::string_view bad_token_;
  std::string joined_;
};

}  // namespace rad::readers
