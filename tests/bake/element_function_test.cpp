#include "bake/element_function.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace rad::bake {
namespace {

constexpr double kDelta = 1e-5;

dvec3 grey(double value) { return dvec3(value); }

FlatElement quadrilateral() { return {{{{0, 0}, {4, 1}, {5, 4}, {-1, 3}}}, {grey(1), grey(5), grey(2), grey(9)}, 4}; }

// The bilinear map itself, corner by corner.
dvec2 place(const FlatElement& q, double s, double t) {
  return q.corner[0] * ((1 - s) * (1 - t)) + q.corner[1] * (s * (1 - t)) + q.corner[2] * (s * t) +
         q.corner[3] * ((1 - s) * t);
}
double value(const FlatElement& q, double s, double t) {
  return q.value[0].x * (1 - s) * (1 - t) + q.value[1].x * s * (1 - t) + q.value[2].x * s * t +
         q.value[3].x * (1 - s) * t;
}

TEST(FlatElement, Triangle_IsLinear_WithItsSlopes) {
  const FlatElement triangle{{{{0, 0}, {4, 0}, {0, 2}}}, {grey(1), grey(9), grey(2)}, 3};
  const FlatValue at = triangle.at({1, 0.5});
  EXPECT_DOUBLE_EQ(at.value.x, 1 + 2 * 1 + 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(at.along_x.x, 2);
  EXPECT_DOUBLE_EQ(at.along_y.x, 0.5);
}

RC_GTEST_PROP(FlatElement, Quadrilateral_IsTheInverseOfTheBilinearMap, ()) {
  const double s = *rc::gen::inRange(0, 1001) / 1000.0, t = *rc::gen::inRange(0, 1001) / 1000.0;
  const FlatElement q = quadrilateral();
  RC_ASSERT(std::abs(q.at(place(q, s, t)).value.x - value(q, s, t)) < 1e-9);
}

TEST(FlatElement, Quadrilateral_SlopesAreThoseOfTheValue) {
  const FlatElement q = quadrilateral();
  const dvec2 at = place(q, 0.3, 0.6);
  const FlatValue there = q.at(at);
  const double along_x = (q.at(at + dvec2(kDelta, 0)).value.x - q.at(at - dvec2(kDelta, 0)).value.x) / (2 * kDelta);
  const double along_y = (q.at(at + dvec2(0, kDelta)).value.x - q.at(at - dvec2(0, kDelta)).value.x) / (2 * kDelta);
  EXPECT_NEAR(there.along_x.x, along_x, 1e-6);
  EXPECT_NEAR(there.along_y.x, along_y, 1e-6);
}

TEST(FlatElement, Contains_ItsBorderWithinTheMargin_AndNothingBeyond) {
  const FlatElement q = quadrilateral();
  EXPECT_TRUE(q.contains({2, 2}, 0));
  EXPECT_TRUE(q.contains({0, 0}, 1e-9));
  EXPECT_FALSE(q.contains({2, 0.4}, 1e-9));
  EXPECT_FALSE(q.contains({-1, 0}, 1e-9));
}

}  // namespace
}  // namespace rad::bake
