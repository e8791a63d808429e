#include "report/run_text.h"

#include <gtest/gtest.h>

#include <charconv>
#include <sstream>

namespace rad::report {
namespace {

using Items = std::vector<std::vector<std::uint64_t>>;

std::string written(const Items& items) {
  RunText text;
  for (const auto& item : items) text.add(item);
  EXPECT_EQ(text.count(), items.size());
  return text.take();
}

std::uint64_t number(std::string_view text) {
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// The other way, as a reader of reports has to do it.
Items read(const std::string& text) {
  Items items;
  std::istringstream tokens(text);
  for (std::string token; tokens >> token;) {
    if (const auto dots = token.find(".."); dots != std::string::npos) {
      for (auto n = number(token); n <= number(token.substr(dots + 2)); ++n) items.push_back({n});
    } else if (const auto star = token.find('*'); star != std::string::npos) {
      items.insert(items.end(), number(token.substr(star + 1)), {number(token)});
    } else {
      items.emplace_back();
      std::istringstream parts(token);
      for (std::string part; std::getline(parts, part, '+');) {
        const auto dash = part.find('-');
        const auto last = dash == std::string::npos ? number(part) : number(part.substr(dash + 1));
        for (auto n = number(part); n <= last; ++n) items.back().push_back(n);
      }
    }
  }
  return items;
}

TEST(RunText, WritesRunsShort) {
  EXPECT_EQ(written({{0}, {1}, {2}, {5}, {5}, {5}, {7}}), "0..2 5*3 7");
  EXPECT_EQ(written({{4, 8, 9, 10}, {3}, {2}, {1, 2}}), "4+8-10 3 2 1-2");
  EXPECT_EQ(written({}), "");
}

TEST(RunText, ReadsBackWhatItWrote) {
  std::uint64_t state = 7;
  const auto next = [&](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (state >> 33) % below;
  };
  for (int round = 0; round < 300; ++round) {
    Items items;
    for (std::uint64_t i = next(12); i > 0; --i) {
      std::vector<std::uint64_t> item{next(4)};
      while (next(4) == 0) item.push_back(item.back() + 1 + next(2));
      items.push_back(std::move(item));
    }
    EXPECT_EQ(read(written(items)), items) << "round " << round;
  }
}

TEST(RunText, AMillionFacesAsTheyWereAreOneToken) {
  RunText text;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) text.add(std::array{i});
  EXPECT_EQ(text.take(), "0..999999");
}

}  // namespace
}  // namespace rad::report
