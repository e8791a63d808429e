#include "readers/text_cursor.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scene/utf8.h"

namespace rad::readers {
namespace {

enum class Class : std::uint8_t { Ordinary, Blank, LineEnd, Backslash };

constexpr std::array<Class, 256> make_classes() {
  std::array<Class, 256> classes{};
  for (const char blank : {' ', '\t', '\v', '\f'}) classes[static_cast<unsigned char>(blank)] = Class::Blank;
  for (const char line_end : {'\n', '\r'}) classes[static_cast<unsigned char>(line_end)] = Class::LineEnd;
  classes['\\'] = Class::Backslash;
  return classes;
}

constexpr std::array<Class, 256> kClasses = make_classes();
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kShownBytes = 40;

Class class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }

bool is_printable(char32_t point) {
  return point >= 0x20 && point != scene::Utf8Character::kNone && (point < 0x7f || point >= 0xa0);
}

// Powers of ten that a double holds exactly.
constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::ptrdiff_t kExactDigits = 15;

// Reads "-12.5" and the like: at most 15 digits, no exponent. Digits and power are then exact in double, so that one
// division rounds correctly (Clinger 1990, section 3). Null where the number is of another form or unfinished.
const char* plain_decimal(const char* at, const char* end, double& value) {
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    const char* const first = at;
    for (; at != end && *at >= '0' && *at <= '9' && at - first <= kExactDigits; ++at) {
      digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    return at - first;
  };
  const std::ptrdiff_t whole = take_digits();
  std::ptrdiff_t fraction = 0;
  if (at != end && *at == '.') {
    ++at;
    fraction = take_digits();
  }
  if (whole + fraction == 0 || whole + fraction > kExactDigits) return nullptr;
  const double size = static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(fraction)];
  value = negative ? -size : size;
  return at;
}

// std::from_chars knows no plus sign; it may stand before anything but another sign.
std::string_view without_plus(std::string_view token) {
  const bool is_plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return is_plus ? token.substr(1) : token;
}

// A number beyond the range of double: its exponent, or the place of its first digit, says to which side.
double beyond_range(std::string_view token) {
  const bool negative = token.starts_with('-');
  const std::size_t exponent = token.find_first_of("eE");
  const std::size_t digit = token.find_first_of("123456789.");
  const bool tiny = exponent != std::string_view::npos ? token.find('-', exponent) != std::string_view::npos
                                                       : digit != std::string_view::npos && token[digit] == '.';
  const double size = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return negative ? -size : size;
}

std::optional<double> old_library_spelling(std::string_view token) {
  const bool negative = token.starts_with('-');
  if (negative) token.remove_prefix(1);
  if (token.starts_with("1.#INF")) return std::copysign(std::numeric_limits<double>::infinity(), negative ? -1.0 : 1.0);
  for (const std::string_view spelling : {"1.#IND", "1.#QNAN", "1.#SNAN"}) {
    if (token.starts_with(spelling)) return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
  token = without_plus(token);
  double value = 0;
  const char* const end = token.data() + token.size();
  const auto [last, error] = std::from_chars(token.data(), end, value);
  if (last == end && error == std::errc()) return value;
  if (last == end && error == std::errc::result_out_of_range) return beyond_range(token);
  return old_library_spelling(token);
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const auto [last, error] = std::from_chars(token.data(), end, value);
  if (last != end || token.empty()) return std::nullopt;
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  using Limits = std::numeric_limits<std::int64_t>;
  return token.front() == '-' ? Limits::min() : Limits::max();
}

std::string in_quotes(std::string_view token) {
  std::string text = "'";
  std::size_t at = 0;
  while (at < token.size()) {
    const scene::Utf8Character next = scene::first_character(token.substr(at));
    if (at + next.bytes > kShownBytes) break;
    text += is_printable(next.point) ? token.substr(at, next.bytes) : "?";
    at += next.bytes;
  }
  text += at < token.size() ? "...'" : "'";
  return text;
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

TextCursor::TextCursor(std::string_view text, std::uint64_t line_limit, Continuation continuation)
    : begin_(text.data()),
      at_(without_byte_order_mark(text).data()),
      end_(text.data() + text.size()),
      line_start_(at_),
      line_limit_(line_limit),
      continuation_(continuation) {}

const char* TextCursor::after_line_end(const char* at) const {
  const bool is_pair = *at == '\r' && at + 1 != end_ && at[1] == '\n';
  return at + (is_pair ? 2 : 1);
}

bool TextCursor::continues_at(const char* at) const {
  return continuation_ == Continuation::Backslash && at + 1 != end_ && class_of(at[1]) == Class::LineEnd;
}

bool TextCursor::ends_token(const char* at) const {
  if (at == end_) return true;
  const Class c = class_of(*at);
  return c == Class::Blank || c == Class::LineEnd || (c == Class::Backslash && continues_at(at));
}

bool TextCursor::at_line_end() const { return at_ == end_ || class_of(*at_) == Class::LineEnd; }

void TextCursor::step_over_line_end() {
  at_ = after_line_end(at_);
  ++line_ends_passed_;
}

void TextCursor::skip_blanks() {
  while (true) {
    while (at_ != end_ && class_of(*at_) == Class::Blank) ++at_;
    if (at_ == end_ || *at_ != '\\' || !continues_at(at_)) return;
    ++at_;
    step_over_line_end();
  }
}

// A backslash at the end of a comment joins nothing: comments hold Windows paths.
void TextCursor::skip_line() {
  bool in_comment = false;
  while (!at_line_end()) {
    const char c = *at_;
    in_comment |= c == '#' && (at_ == line_start_ || ends_token(at_ - 1));
    const bool continues = c == '\\' && !in_comment && continues_at(at_);
    ++at_;
    if (continues) step_over_line_end();
  }
}

bool TextCursor::next_line() {
  if (started_) {
    skip_line();
    passed_line_limit_ = static_cast<std::uint64_t>(at_ - line_start_) > line_limit_;
    if (at_ != end_) step_over_line_end();
  }
  started_ = true;
  if (at_ == end_ || passed_line_limit_) return false;
  line_start_ = at_;
  line_ = line_ends_passed_ + 1;
  return true;
}

const char* TextCursor::token_end() const {
  const char* last = at_;
  while (true) {
    while (last != end_ && class_of(*last) == Class::Ordinary) ++last;
    if (ends_token(last)) return last;
    ++last;
  }
}

std::string_view TextCursor::next_token() {
  skip_blanks();
  if (at_line_end() || *at_ == '#') return {};
  const char* const first = at_;
  at_ = token_end();
  return {first, static_cast<std::size_t>(at_ - first)};
}

TextCursor::Token TextCursor::next_number(double& value) {
  skip_blanks();
  if (at_line_end() || *at_ == '#') return Token::Absent;
  double parsed = 0;
  if (const char* const last = plain_decimal(at_, end_, parsed); last != nullptr && ends_token(last)) {
    at_ = last;
    value = parsed;
    return Token::Good;
  }
  const auto [last, error] = std::from_chars(at_, end_, parsed);
  if (error == std::errc() && ends_token(last)) {
    at_ = last;
    value = parsed;
    return Token::Good;
  }
  const std::string_view token = next_token();
  if (const auto unusual = parse_number(token)) {
    value = *unusual;
    return Token::Good;
  }
  bad_token_ = token;
  return Token::Bad;
}

TextCursor::Token TextCursor::next_integer(std::int64_t& value) {
  const std::string_view token = next_token();
  if (token.empty()) return Token::Absent;
  if (const auto parsed = parse_integer(token)) {
    value = *parsed;
    return Token::Good;
  }
  bad_token_ = token;
  return Token::Bad;
}

std::string_view TextCursor::rest() {
  skip_blanks();
  joined_.clear();
  const char* first = at_;
  while (!at_line_end()) {
    if (*at_ != '\\' || !continues_at(at_)) {
      ++at_;
      continue;
    }
    joined_.append(first, at_).push_back(' ');
    ++at_;
    step_over_line_end();
    first = at_;
  }
  std::string_view text(first, static_cast<std::size_t>(at_ - first));
  if (!joined_.empty()) text = joined_.append(text);
  while (!text.empty() && class_of(text.back()) == Class::Blank) text.remove_suffix(1);
  return text;
}

}  // namespace rad::readers
