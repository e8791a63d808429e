// Scaled ρ against shapes whose circles are known.
#include "geom/planar_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rad::geom {
namespace {

using Polygon = std::vector<PlanePoint>;

TEST(PlanarShape, OfTheBestIsOne) {
  EXPECT_NEAR(scaled_shape(Polygon{{0, 0}, {2, 0}, {1, std::sqrt(3)}}), 1, 1e-12);
  EXPECT_NEAR(scaled_shape(Polygon{{1, 1}, {4, 1}, {4, 4}, {1, 4}}), 1, 1e-12);
}

TEST(PlanarShape, OfRectanglesFallsWithTheirLength) {
  for (const double length : {2.0, 4.0, 50.0}) {
    const double expected = std::sqrt(2) / std::hypot(length, 1);
    EXPECT_NEAR(scaled_shape(Polygon{{0, 0}, {length, 0}, {length, 1}, {0, 1}}), expected, 1e-12);
  }
}

// 2 r/R of a right triangle: r = (a + b - c)/2, R = c/2.
TEST(PlanarShape, OfARightTriangle) { EXPECT_NEAR(scaled_shape(Polygon{{0, 0}, {4, 0}, {0, 3}}), 2 * 1 / 2.5, 1e-12); }

TEST(PlanarShape, OfARhombusIsThatOfItsCircles) {
  const double h = std::sqrt(3) / 2;
  EXPECT_NEAR(scaled_shape(Polygon{{0, 0}, {1, 0}, {1.5, h}, {0.5, h}}), std::sqrt(2) * (h / 2) / h, 1e-12);
}

}  // namespace
}  // namespace rad::geom
