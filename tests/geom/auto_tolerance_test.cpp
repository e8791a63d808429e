// --tolerance auto: T between noise and features, or the default.
#include "geom/auto_tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rad::geom {
namespace {

// The default T is 1e-3, the largest automatic one 1e-2.
ToleranceBasis basis() {
  return {.pitch = 0x1p-30, .diagonal = 100, .median_object_diagonal = 500, .largest_magnitude = 80};
}

std::vector<double> spread(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return values;
}

std::vector<double> both(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(AutoTolerance, LiesInTheMiddleOfTheGap) {
  const Tolerance t = auto_tolerance(basis(), both(spread(1e-6, 2e-5, 100), spread(2e-3, 0.9, 100)));
  EXPECT_EQ(t.source, ToleranceSource::Auto);
  EXPECT_NEAR(t.length, 2e-4, 2e-6);
  ASSERT_TRUE(t.choice.has_value());
  EXPECT_NEAR(t.choice->confidence, 2, 1e-9);
  EXPECT_EQ(t.choice->low, 2e-5);
  EXPECT_EQ(t.choice->high, 2e-3);
  EXPECT_NEAR(t.choice->usual, 1e-3, 1e-6);
  EXPECT_EQ(t.choice->joined, 0u);
}

TEST(AutoTolerance, TakesTheWidestGap) {
  const auto modes = both(both(spread(1e-6, 1e-5, 30), spread(5e-4, 1e-3, 30)), spread(3e-2, 0.9, 30));
  EXPECT_NEAR(auto_tolerance(basis(), modes).choice->confidence, std::log10(50), 1e-9);
}

TEST(AutoTolerance, DoesNotDependOnTheOrder) {
  auto distances = both(spread(1e-6, 2e-5, 100), spread(2e-3, 0.9, 100));
  const Tolerance first = auto_tolerance(basis(), distances);
  std::shuffle(distances.begin(), distances.end(), std::mt19937(7));
  EXPECT_EQ(auto_tolerance(basis(), distances).pitches, first.pitches);
}

TEST(AutoTolerance, IsTheDefaultWhereThereIsNoGap) {
  for (const auto& distances : {std::vector<double>{}, std::vector<double>{0.5}, spread(1e-6, 0.9, 300),
                                spread(5e-2, 0.9, 30), both(spread(2e-2, 3e-2, 30), spread(0.5, 0.9, 30))}) {
    const Tolerance t = auto_tolerance(basis(), distances);
    EXPECT_EQ(t.source, ToleranceSource::Default);
    EXPECT_EQ(t.length, default_tolerance(basis()).length);
    ASSERT_TRUE(t.choice.has_value());
    EXPECT_EQ(t.choice->confidence, 0);
  }
}

TEST(AutoTolerance, StaysWithinItsBounds) {
  // The middle of the gap is above the largest T: T is the largest, well inside the gap.
  const auto wide = both(spread(1e-3, 2e-3, 10), spread(0.8, 0.9, 10));
  EXPECT_NEAR(auto_tolerance(basis(), wide).length, 1e-2, 1e-6);
  // And below the smallest: single precision at 4096 needs 8/2048.
  ToleranceBasis coarse = basis();
  coarse.single_precision = true;
  coarse.largest_magnitude = 5000;
  EXPECT_NEAR(auto_tolerance(coarse, both(spread(1e-5, 2e-4, 10), spread(0.1, 0.9, 10))).length, 0.0044721, 1e-6);
  EXPECT_EQ(auto_tolerance(coarse, both(spread(1e-6, 2e-6, 10), spread(0.1, 0.9, 10))).length, 8 * 0x1p-11);
}

TEST(AutoTolerance, CountsWhatTheDefaultWouldKeepOpen) {
  const auto modes = both(both(spread(1e-6, 1e-4, 30), {1.5e-3, 2e-3, 2.5e-3}), spread(0.2, 0.9, 30));
  const Tolerance t = auto_tolerance(basis(), modes);
  ASSERT_GT(t.length, 2.5e-3);
  EXPECT_EQ(t.choice->joined, 3u);
}

TEST(AutoTolerance, GivesWayToWhatTheFileRecords) {
  ToleranceBasis recorded = basis();
  recorded.recorded = 0.004;
  const Tolerance t = auto_tolerance(recorded, both(spread(1e-6, 2e-5, 100), spread(2e-3, 0.9, 100)));
  EXPECT_EQ(t.source, ToleranceSource::Recorded);
  EXPECT_FALSE(t.choice.has_value());
}

TEST(AutoTolerance, IsParsed) {
  EXPECT_EQ(parse_tolerance("auto")->measure, ToleranceRequest::Measure::Auto);
  EXPECT_FALSE(parse_tolerance("automatic").has_value());
}

}  // namespace
}  // namespace rad::geom
