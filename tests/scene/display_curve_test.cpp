#include "scene/display_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rad::scene {
namespace {

using geom::dvec3;

constexpr DisplayCurve kBending[] = {DisplayCurve::Shoulder, DisplayCurve::Reinhard};

TEST(DisplayCurve, Linear_ChangesNothing) { EXPECT_EQ(curved(DisplayCurve::Linear, {0.1, 2, 0}), dvec3(0.1, 2, 0)); }

TEST(DisplayCurve, OthersKeepTheRatiosOfChannels_AndRiseWithTheLight) {
  for (const DisplayCurve curve : kBending) {
    double last = -1;
    for (double value = 0; value < 50; value += 0.01) {
      const dvec3 shown = curved(curve, value * dvec3(1, 0.5, 0.25));
      EXPECT_NEAR(shown.y, shown.x / 2, 1e-12) << name(curve);
      EXPECT_NEAR(shown.z, shown.x / 4, 1e-12) << name(curve);
      EXPECT_GT(shown.x, last) << name(curve) << value;
      last = shown.x;
    }
  }
}

TEST(DisplayCurve, Shoulder_IsLinearBelowTheKnee_SmoothAtIt_AndNeverReachesWhite) {
  const auto shown = [](double value) { return curved(DisplayCurve::Shoulder, dvec3(value)).x; };
  EXPECT_EQ(shown(0.5), 0.5);
  EXPECT_DOUBLE_EQ(shown(kKnee), kKnee);
  EXPECT_NEAR((shown(kKnee + 1e-6) - kKnee) / 1e-6, 1, 1e-4);
  EXPECT_NEAR(shown(0.8), 0.6 + 0.4 / 3, 1e-12);
  EXPECT_LT(shown(1e6), 1);
}

TEST(DisplayCurve, Reinhard_ShowsItsWhiteAsOne) {
  EXPECT_NEAR(luminance(curved(DisplayCurve::Reinhard, dvec3(kReinhardWhite))), 1, 1e-12);
  EXPECT_NEAR(curved(DisplayCurve::Reinhard, dvec3(1e-9)).x, 1e-9, 1e-15);
}

TEST(DisplayCurve, FalseColours_RiseInLuminance_AndEndAtBothSides) {
  double last = -1;
  for (double value = 0; value <= 1; value += 0.001) {
    const double seen = luminance(curved(DisplayCurve::FalseColour, dvec3(value)));
    EXPECT_GT(seen, last) << value;
    last = seen;
  }
  EXPECT_EQ(false_colour(-3), false_colour(0));
  EXPECT_EQ(false_colour(7), false_colour(1));
  EXPECT_EQ(std::lround(255 * (1.055 * std::pow(false_colour(1).x, 1 / 2.4) - 0.055)), 0xfd);
}

TEST(DisplayCurve, OfNoLight_IsBlack) {
  for (const DisplayCurve curve : kBending) EXPECT_EQ(curved(curve, dvec3(0)), dvec3(0));
}

}  // namespace
}  // namespace rad::scene
