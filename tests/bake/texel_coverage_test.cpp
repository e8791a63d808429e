#include "bake/texel_coverage.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace rad::bake {
namespace {

constexpr std::int64_t kSide = 12;

std::vector<double> coverage(const FlatElement& element) {
  std::vector<double> shares(kSide * kSide, 0);
  for (std::int64_t row = 0; row < kSide; ++row) {
    add_coverage(element, {row, std::span(shares).subspan(static_cast<std::size_t>(row * kSide), kSide)});
  }
  return shares;
}

double area(const FlatElement& element) {
  double doubled = 0;
  for (std::uint32_t i = 0; i < element.count; ++i) {
    const dvec2 &a = element.corner[i], &b = element.corner[(i + 1) % element.count];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

TEST(TexelCoverage, SquareOnTexelBorders_CoversThemWholly) {
  const FlatElement square{{{{0.5, 0.5}, {3.5, 0.5}, {3.5, 2.5}, {0.5, 2.5}}}, {}, 4};
  const std::vector<double> shares = coverage(square);
  for (std::int64_t row = 0; row < kSide; ++row) {
    for (std::int64_t column = 0; column < kSide; ++column) {
      const bool within = column >= 1 && column <= 3 && row >= 1 && row <= 2;
      EXPECT_DOUBLE_EQ(shares[static_cast<std::size_t>(row * kSide + column)], within ? 1 : 0);
    }
  }
}

TEST(TexelCoverage, SquareThroughCentres_CoversHalvesAndQuarters) {
  const FlatElement square{{{{1, 1}, {3, 1}, {3, 2}, {1, 2}}}, {}, 4};
  const std::vector<double> shares = coverage(square);
  EXPECT_DOUBLE_EQ(shares[kSide + 1], 0.25);
  EXPECT_DOUBLE_EQ(shares[kSide + 2], 0.5);
  EXPECT_DOUBLE_EQ(shares[2 * kSide + 3], 0.25);
}

RC_GTEST_PROP(TexelCoverage, OfAnyTriangle_SumsToItsArea, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(0, 1101) / 100.0; };
  FlatElement triangle;
  for (int i = 0; i < 3; ++i) triangle.corner[static_cast<std::size_t>(i)] = {coordinate(), coordinate()};
  if (area(triangle) < 0) std::swap(triangle.corner[1], triangle.corner[2]);
  RC_PRE(area(triangle) > 0);
  const std::vector<double> shares = coverage(triangle);
  RC_ASSERT(std::abs(std::accumulate(shares.begin(), shares.end(), 0.0) - area(triangle)) < 1e-9);
  RC_ASSERT(std::ranges::all_of(shares, [](double share) { return share > -1e-12 && share < 1 + 1e-12; }));
}

}  // namespace
}  // namespace rad::bake
