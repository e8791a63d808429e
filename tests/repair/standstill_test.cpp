#include "repair/standstill.h"

#include <gtest/gtest.h>

namespace rad::repair {
namespace {

using Left = Standstill::Left;

// How many rounds there are until a standstill; 1000 where there is none.
template <typename LeftAt>
int rounds_until(LeftAt left_at) {
  Standstill standstill;
  for (int round = 0; round < 1000; ++round) {
    if (standstill.after(left_at(round))) return round;
  }
  return 1000;
}

TEST(Standstill, IsNoneWhileLessIsLeft) {
  EXPECT_EQ(rounds_until([](int round) { return Left{false, true, 5000U - static_cast<unsigned>(round), 900}; }), 1000);
}

TEST(Standstill, ComesWhereStatesRepeat) {
  const int rounds = rounds_until([](int round) { return Left{false, true, round % 7 + 3U, 900}; });
  EXPECT_GT(rounds, 40);
  EXPECT_LT(rounds, 100);
}

TEST(Standstill, WaitsWhereAFewRoundsLeaveMore) {
  EXPECT_EQ(rounds_until([](int round) { return Left{false, true, 100000U - 100U * (round / 40), 900}; }), 1000);
}

TEST(Standstill, ComesAtOnceWhereTrianglesRunAway) {
  const auto doubling = [](int round) { return Left{false, true, 50U << round, std::size_t{300} << round}; };
  EXPECT_EQ(rounds_until(doubling), 4);
}

// Contacts are looked for only where nothing worse is left; more of them are less than that.
TEST(Standstill, ContactsAreLessThanAnythingWorse) {
  EXPECT_EQ(
      rounds_until([](int round) {
        if (round < 50) return Left{true, true, 1, 900};
        return round < 100 ? Left{false, true, 40, 900} : Left{false, false, 4000U - static_cast<unsigned>(round), 900};
      }),
      1000);
}

}  // namespace
}  // namespace rad::repair
