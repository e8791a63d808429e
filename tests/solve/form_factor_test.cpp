#include "solve/form_factor.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "solve/strata.h"

namespace rad::solve {
namespace {

constexpr double kPi = std::numbers::pi;

double factor(const std::vector<dvec3>& polygon, const Receiver& receiver) {
  return form_factor(above_horizon(polygon, receiver), receiver.normal);
}

/// Faces down at height 1, as seen from receivers below it.
std::vector<dvec3> ceiling(double half_x, double half_y, double height) {
  return {{-half_x, half_y, height}, {half_x, half_y, height}, {half_x, -half_y, height}, {-half_x, -half_y, height}};
}

/// The defining integral by the midpoint rule on n × n cells.
double integrated(const std::vector<dvec3>& rectangle, const Receiver& receiver, int n) {
  const dvec3 u = (rectangle[1] - rectangle[0]) / double(n), v = (rectangle[3] - rectangle[0]) / double(n);
  const dvec3 area = glm::cross(u, v);
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const dvec3 r = rectangle[0] + u * (i + 0.5) + v * (j + 0.5) - receiver.position;
      const double cosines = std::max(0.0, glm::dot(r, receiver.normal)) * std::max(0.0, -glm::dot(r, area));
      sum += cosines / (kPi * glm::dot(r, r) * glm::dot(r, r));
    }
  }
  return sum;
}

/// From a point to a parallel rectangle a × b at height c with a corner above the point (configuration factor in closed
/// form, as in every handbook of radiative transfer).
double corner_parallel(double a, double b, double c) {
  const double x = a / c, y = b / c;
  return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
         (2 * kPi);
}

TEST(FormFactor, FromAPointToAParallelRectangleIsTheHandbooks) {
  for (const double height : {0.05, 0.3, 1.0, 4.0}) {
    const double quarter = corner_parallel(0.5, 0.8, height);
    EXPECT_NEAR(factor(ceiling(0.5, 0.8, height), {{0, 0, 0}, {0, 0, 1}}), 4 * quarter, 1e-12);
  }
}

TEST(FormFactor, FromAPointOnTheFloorToAWallIsTheHandbooks) {
  // Wall in the plane x = 0 from y = 0 to b, z = 0 to h; the point stands before its end at distance d.
  const double b = 0.7, h = 1.3, d = 0.4;
  const std::vector<dvec3> wall{{0, 0, 0}, {0, b, 0}, {0, b, h}, {0, 0, h}};
  const double slant = std::sqrt(d * d + h * h);
  const double expected = (std::atan(b / d) - d / slant * std::atan(b / slant)) / (2 * kPi);
  EXPECT_NEAR(factor(wall, {{d, 0, 0}, {0, 0, 1}}), expected, 1e-12);
}

TEST(FormFactor, AgreesWithTheIntegralWhereTheHorizonCuts) {
  const dvec3 normal = glm::normalize(dvec3(0.8, 0.1, 0.4));
  const Receiver receiver{{0.2, -0.1, 0}, normal};
  const auto polygon = ceiling(1, 0.7, 0.6);
  EXPECT_NEAR(factor(polygon, receiver), integrated(polygon, receiver, 1500), 2e-5);
  EXPECT_LT(factor(polygon, receiver), factor(polygon, {{0.2, -0.1, 0}, {0, 0, 1}}));
}

TEST(FormFactor, BelowTheHorizonIsNothing) {
  EXPECT_EQ(above_horizon(ceiling(1, 1, 1), {{0, 0, 0}, {0, 0, -1}}).count, 0u);
  EXPECT_EQ(factor(ceiling(1, 1, 1), {{0, 0, 0}, {0, 0, -1}}), 0.0);
}

TEST(FormFactor, OfThePlaneOfTheReceiverIsNothing) { EXPECT_EQ(factor(ceiling(1, 1, 0), {{3, 0, 0}, {0, 0, 1}}), 0.0); }

TEST(FormFactor, BackIsNothing) {
  const std::vector<dvec3> upward{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  EXPECT_EQ(factor(upward, {{0, 0, 0}, {0, 0, 1}}), 0.0);
}

TEST(FormFactor, AlmostOnTheRadiatorItIsOne) {
  EXPECT_NEAR(factor(ceiling(1, 1, 1e-6), {{0, 0, 0}, {0, 0, 1}}), 1.0, 1e-5);
}

TEST(FormFactor, AtTheFootOfAWallItIsOneHalf) {
  const std::vector<dvec3> wall{{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}};
  EXPECT_NEAR(factor(wall, {{1e-6, 0, 0}, {0, 0, 1}}), 0.5, 1e-5);
}

double drawn(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high)) / 1000.0; }

RC_GTEST_PROP(FormFactorProperty, PiecesAddUpToTheWhole, ()) {
  const dvec3 origin{drawn(-2000, 2000), drawn(-2000, 2000), drawn(10, 2000)};
  const dvec3 u{drawn(100, 2000), drawn(-500, 500), drawn(-500, 500)};
  const dvec3 v{drawn(-500, 500), drawn(-2000, -100), drawn(-500, 500)};
  const Receiver receiver{{0, 0, 0}, glm::normalize(dvec3(drawn(-900, 900), drawn(-900, 900), 0.5))};
  const bool triangle = *rc::gen::arbitrary<bool>();
  std::vector<dvec3> polygon{origin, origin + u, origin + u + v};
  if (!triangle) polygon.push_back(origin + v);
  const double turn = glm::dot(glm::cross(u, v), origin);
  RC_PRE(std::abs(turn) > 1e-3);
  if (turn > 0) std::reverse(polygon.begin(), polygon.end());
  double sum = 0;
  for (const Stratum& piece : strata(whole(polygon), 3)) {
    sum += form_factor(above_horizon(piece.all(), receiver), receiver.normal);
  }
  RC_ASSERT(std::abs(sum - factor(polygon, receiver)) < 1e-12);
}

}  // namespace
}  // namespace rad::solve
