#include "readers/text_cursor.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace rad::readers {
namespace {

using Token = TextCursor::Token;
using Lines = std::vector<std::pair<std::uint64_t, std::vector<std::string>>>;

Lines lines_of(std::string_view text, TextCursor::Continuation continuation = TextCursor::Continuation::None) {
  Lines lines;
  TextCursor cursor(text, 1000, continuation);
  while (cursor.next_line()) {
    std::vector<std::string> tokens;
    for (auto token = cursor.next_token(); !token.empty(); token = cursor.next_token()) tokens.emplace_back(token);
    lines.emplace_back(cursor.line(), tokens);
  }
  return lines;
}

TEST(TextCursor, NumbersLinesOfEveryEnding) {
  const Lines expected = {{1, {"a", "b"}}, {2, {}}, {3, {"c"}}};
  EXPECT_EQ(lines_of("a b\n\nc\n"), expected);
  EXPECT_EQ(lines_of("a b\r\n\r\nc"), expected);
  EXPECT_EQ(lines_of("a b\r\rc\r"), expected);
  EXPECT_EQ(lines_of("\ta\t b \n \n  c#\n"), (Lines{{1, {"a", "b"}}, {2, {}}, {3, {"c#"}}}));
}

TEST(TextCursor, HasNoLineInAnEmptyText) {
  EXPECT_TRUE(lines_of("").empty());
  EXPECT_EQ(lines_of("\n").size(), 1u);
}

TEST(TextCursor, HidesComments) { EXPECT_EQ(lines_of("a # b\n# c\nd"), (Lines{{1, {"a"}}, {2, {}}, {3, {"d"}}})); }

TEST(TextCursor, StepsOverAByteOrderMark) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a"),
            (Lines{{1, {"a"}}}));
}

TEST(TextCursor, JoinsContinuedLinesAndKeepsTheNumberOfTheFirst) {
  const auto backslash = TextCursor::Continuation::Backslash;
  EXPECT_EQ(lines_of("a \\\nb\\\r\nc\nd", backslash), (Lines{{1, {"a", "b", "c"}}, {4, {"d"}}}));
  EXPECT_EQ(lines_of("a\\b \\\n", backslash), (Lines{{1, {"a\\b"}}}));
  EXPECT_EQ(lines_of("# c:\\dir\\\nd", backslash), (Lines{{1, {}}, {2, {"d"}}}));
  EXPECT_EQ(lines_of("a \\\nb").size(), 2u);
}

TEST(TextCursor, GivesTheRestOfALine) {
  TextCursor cursor("o  Wall #2 \t\ng a\\\nb", 1000, TextCursor::Continuation::Backslash);
  ASSERT_TRUE(cursor.next_line());
  cursor.next_token();
  EXPECT_EQ(cursor.rest(), "Wall #2");
  ASSERT_TRUE(cursor.next_line());
  cursor.next_token();
  EXPECT_EQ(cursor.rest(), "a b");
  EXPECT_FALSE(cursor.next_line());
}

TEST(TextCursor, StopsAfterALineBeyondTheLimit) {
  TextCursor cursor("1234\n12345\n1\n", 4);
  EXPECT_TRUE(cursor.next_line());
  EXPECT_TRUE(cursor.next_line());
  EXPECT_FALSE(cursor.next_line());
  EXPECT_TRUE(cursor.passed_line_limit());
}

TEST(TextCursor, ReadsNumbersOneByOne) {
  TextCursor cursor("+1.5 2. x 4");
  double value = 0;
  EXPECT_FALSE(cursor.next_line() && cursor.next_number(value) != Token::Good);
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(cursor.next_number(value), Token::Good);
  EXPECT_EQ(value, 2.0);
  EXPECT_EQ(cursor.next_number(value), Token::Bad);
  EXPECT_EQ(cursor.bad_token(), "x");
  EXPECT_EQ(value, 2.0);
  std::int64_t whole = 0;
  EXPECT_EQ(cursor.next_integer(whole), Token::Good);
  EXPECT_EQ(whole, 4);
  EXPECT_EQ(cursor.next_number(value), Token::Absent);
}

TEST(ParseNumber, AcceptsEverySpellingInUse) {
  EXPECT_EQ(parse_number("+2.e1"), 20.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("-0"), 0.0);
  EXPECT_EQ(parse_number("1E-2"), 0.01);
  EXPECT_TRUE(std::isnan(*parse_number("NaN")));
  EXPECT_TRUE(std::isnan(*parse_number("-nan(ind)")));
  EXPECT_TRUE(std::isnan(*parse_number("-1.#IND")));
  EXPECT_EQ(parse_number("+inf"), HUGE_VAL);
  EXPECT_EQ(parse_number("-1.#INF00"), -HUGE_VAL);
}

TEST(ParseNumber, KeepsTheSideOnWhichANumberLeavesTheRange) {
  EXPECT_EQ(parse_number("1e400"), HUGE_VAL);
  EXPECT_EQ(parse_number("-1e400"), -HUGE_VAL);
  EXPECT_EQ(parse_number("-1e-400"), 0.0);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_number("1" + std::string(400, '0')), HUGE_VAL);
}

TEST(ParseNumber, RefusesWhatIsNoNumber) {
  for (const char* token : {"", "+", "-", ".", "+-1", "++1", "1,5", "1e", "3.1+e2", "0x10", "1 ", "abc", "infx"}) {
    EXPECT_FALSE(parse_number(token)) << token;
  }
}

// The cursor reads plain decimals by a way of its own: it must round as the general way does.
TEST(TextCursor, RoundsPlainDecimalsCorrectly) {
  std::uint64_t state = 1;
  for (int i = 0; i < 200'000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::string digits = std::to_string(state >> (state % 50));
    const std::size_t point = (state >> 8) % (digits.size() + 1);
    const std::string text = ((state & 16) != 0 ? "-" : "") + digits.substr(0, point) + "." + digits.substr(point);
    TextCursor cursor(text);
    double value = 0;
    ASSERT_TRUE(cursor.next_line());
    ASSERT_EQ(cursor.next_number(value), Token::Good) << text;
    ASSERT_EQ(value, parse_number(text)) << text;
    ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseNumber, DoesNotDependOnTheLocale) {
  const char* const set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(parse_number("1.5"), 1.5);
  if (set != nullptr) std::setlocale(LC_ALL, "C");
}

TEST(ParseInteger, SaturatesAndRefuses) {
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_EQ(parse_integer("-7"), -7);
  EXPECT_EQ(parse_integer("99999999999999999999"), INT64_MAX);
  EXPECT_EQ(parse_integer("-99999999999999999999"), INT64_MIN);
  for (const char* token : {"", "+", "1.0", "a", "1/2", "+-1"}) EXPECT_FALSE(parse_integer(token)) << token;
}

TEST(InQuotes, ShowsWhatCanBePrinted) {
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes("a\x01\xC3"),
            "'a"
            "?"
            "?'");
  EXPECT_EQ(in_quotes("Möbel 部屋"), "'Möbel 部屋'");
  EXPECT_EQ(in_quotes("a\u0085"), "'a?'");  // a control character
  EXPECT_EQ(in_quotes(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
  EXPECT_EQ(in_quotes(std::string(39, 'x') + "öy"), "'" + std::string(39, 'x') + "...'");  // not within a character
}

}  // namespace
}  // namespace rad::readers
