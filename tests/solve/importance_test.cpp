#include "solve/importance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rad::solve {
namespace {

TEST(Importance, IsTheGreatestShareOverTheChannels) {
  Importance importance;
  importance.radiosity = {{2, 3, 4}, {0, 0, 0}};
  importance.irradiance = {{0, 0, 0}, {4, 1, 8}};
  EXPECT_EQ(importance.of(0, 1), 3);
  EXPECT_EQ(importance.of(1, 1), 0);
  EXPECT_EQ(importance.of(0, 0), 0) << "nothing is ever received there";
}

TEST(Importance, StrataHoldAHalfCoveredRadiatorBelowTheNoise) {
  Importance importance;
  importance.noise = 1e-3;
  int before = 0;
  for (double share = 1e-4; share < 2; share *= 1.1) {
    const int level = importance.level_for(share);
    EXPECT_GE(level, before);
    before = level;
    if (level == kDeepestStrata) break;
    EXPECT_LE(0.4 * share * std::pow(4.0, -0.75 * level), 1e-3 * (1 + 1e-12));
    if (level > 0) {
      EXPECT_GT(0.4 * share * std::pow(4.0, -0.75 * (level - 1)), 1e-3 * (1 - 1e-12));
    }
  }
  EXPECT_EQ(before, kDeepestStrata);
  EXPECT_EQ(importance.level_for(1e6), kDeepestStrata);
}

}  // namespace
}  // namespace rad::solve
