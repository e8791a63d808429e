#include "solve/strata.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "solve/radiators.h"
#include "solve/random.h"

namespace rad::solve {
namespace {

const std::vector<dvec3> kTriangle{{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}};
const std::vector<dvec3> kTrapezoid{{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0.5, 1, 0}};

double area(const Stratum& piece) {
  dvec3 twice(0);
  for (std::uint32_t i = 2; i < piece.count; ++i) {
    twice += glm::cross(piece.corner[i - 1] - piece.corner[0], piece.corner[i] - piece.corner[0]);
  }
  return twice.z / 2;
}

TEST(Strata, PiecesCoverTheWholeAndKeepItsTurn) {
  for (const auto& polygon : {kTriangle, kTrapezoid}) {
    const auto pieces = strata(whole(polygon), 3);
    EXPECT_EQ(pieces.size(), 64u);
    double sum = 0;
    for (const Stratum& piece : pieces) {
      EXPECT_GT(area(piece), 0);
      sum += area(piece);
    }
    EXPECT_NEAR(sum, area(whole(polygon)), 1e-12);
  }
}

double linear(const dvec3& point) { return 3 + 2 * point.x - 5 * point.y; }

TEST(Strata, ShapeReproducesLinearFunctions) {
  for (const auto& polygon : {kTriangle, kTrapezoid}) {
    const Stratum all = whole(polygon);
    for (const Stratum& piece : strata(all, 2)) {
      const Shares shares = shape_at_centre(piece);
      double value = shares[kCentreShare] * linear(all.centre());
      for (std::size_t i = 0; i < polygon.size(); ++i) value += shares[i] * linear(polygon[i]);
      EXPECT_NEAR(value, linear(piece.centre()), 1e-12);
    }
  }
}

TEST(Strata, ShapeIsTheCentresValueAtTheCentre) {
  for (const auto& polygon : {kTriangle, kTrapezoid}) {
    const Shares shares = shape_at_centre(whole(polygon));
    EXPECT_NEAR(shares[kCentreShare], 1, 1e-12);
    EXPECT_NEAR(shares[0], 0, 1e-12);
  }
}

/// Mean over a fine split, by area.
template <typename Function>
double mean_by_pieces(const std::vector<dvec3>& polygon, Function&& function) {
  double sum = 0, total = 0;
  for (const Stratum& piece : strata(whole(polygon), 6)) {
    sum += area(piece) * function(piece.centre());
    total += area(piece);
  }
  return sum / total;
}

TEST(Strata, MeanOfLinearFunctionsIsExact) {
  for (const auto& polygon : {kTriangle, kTrapezoid}) {
    const Shares shares = mean_shares(polygon);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
    double mean = shares[kCentreShare] * linear(whole(polygon).centre());
    for (std::size_t i = 0; i < polygon.size(); ++i) mean += shares[i] * linear(polygon[i]);
    EXPECT_NEAR(mean, mean_by_pieces(polygon, linear), 2e-4);
  }
}

TEST(Strata, MeanOfQuadraticFunctionsIsExactOnTrianglesAndParallelograms) {
  const auto quadratic = [](const dvec3& p) { return p.x * p.x + 2 * p.x * p.y - p.y * p.y; };
  const std::vector<dvec3> parallelogram{{0, 0, 0}, {2, 0, 0}, {2.5, 1, 0}, {0.5, 1, 0}};
  for (const auto& polygon : {kTriangle, parallelogram}) {
    const Shares shares = mean_shares(polygon);
    double mean = shares[kCentreShare] * quadratic(whole(polygon).centre());
    for (std::size_t i = 0; i < polygon.size(); ++i) mean += shares[i] * quadratic(polygon[i]);
    EXPECT_NEAR(mean, mean_by_pieces(polygon, quadratic), 2e-4);
  }
}

TEST(Jitter, IsUniformAndTheSameForTheSameKeys) {
  double sum = 0, product = 0;
  constexpr int kCount = 20000;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto [u, v] = jitter(7, i / 16, i % 16, 0);
    ASSERT_GT(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    product += (u - 0.5) * (v - 0.5);
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.01);     // five standard errors
  EXPECT_NEAR(product / kCount, 0, 0.003);  // five standard errors of 1/12/√n
  EXPECT_EQ(jitter(1, 2, 3, 4), jitter(1, 2, 3, 4));
  EXPECT_NE(jitter(1, 2, 3, 4), jitter(2, 1, 3, 4));
  EXPECT_NE(jitter(1, 2, 3, 4), jitter(1, 2, 4, 3));
}

}  // namespace
}  // namespace rad::solve
