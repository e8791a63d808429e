#include "bake/flat_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace rad::bake {
namespace {

std::vector<dvec2> turned(std::vector<dvec2> points, double angle) {
  for (dvec2& p : points) {
    p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
  }
  return points;
}

TEST(ConvexHull, SquareWithPointsInsideAndOnEdges_IsItsCorners) {
  const std::vector<dvec2> points{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 1}};
  EXPECT_EQ(convex_hull(points).size(), 4u);
}

TEST(LeastRectangle, OfARectangle_IsItself_HoweverItLies) {
  for (const double angle : {0.0, 0.3, 1.2, 2.0, 3.1, 4.5, 6.0}) {
    const std::vector<dvec2> points = turned({{1, 1}, {4, 1}, {4, 2}, {1, 2}, {2, 1.5}}, angle);
    const FlatRectangle rectangle = least_rectangle(points);
    EXPECT_NEAR(rectangle.length, 3, 1e-12);
    EXPECT_NEAR(rectangle.breadth, 1, 1e-12);
    const dvec2 across(-rectangle.along.y, rectangle.along.x);
    for (const dvec2& point : points) {
      const dvec2 way = point - rectangle.corner;
      EXPECT_GE(glm::dot(way, rectangle.along), -1e-12);
      EXPECT_LE(glm::dot(way, rectangle.along), 3 + 1e-12);
      EXPECT_GE(glm::dot(way, across), -1e-12);
      EXPECT_LE(glm::dot(way, across), 1 + 1e-12);
    }
  }
}

TEST(LeastRectangle, UprightOrLyingShape_LengthIsTheLongerSide) {
  const FlatRectangle rectangle = least_rectangle(std::vector<dvec2>{{0, 0}, {1, 0}, {1, 5}, {0, 5}});
  EXPECT_DOUBLE_EQ(rectangle.length, 5);
  EXPECT_DOUBLE_EQ(rectangle.breadth, 1);
}

}  // namespace
}  // namespace rad::bake
