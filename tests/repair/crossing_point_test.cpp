// Which point an edge and a plane get in common, at small angles above all.
#include "repair/crossing_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/repair/drawn_complex.h"

namespace rad::repair {
namespace {

constexpr std::int64_t kTolerance = 32;
constexpr double kT = kTolerance;

// An edge along x through a plane that it passes at x = 0, and a point in use at `place`.
class Crossing : public tests::ComplexSketch {
 public:
  Crossing(double sine, const LatticePoint& place)
      : ComplexSketch(kT), plane_({sine, 0, std::sqrt(1 - sine * sine)}, {}) {
    const ClusterId other = plane({0, 1, 0});
    piece(other, {{-9000, 0, 0}, {9000, 0, 0}, {0, 0, 9000}});
    piece(other, {place, {4000, 0, -5000}, {-4000, 0, -5000}});
    edge_ = edge_key(point({-9000, 0, 0}), point({9000, 0, 0}));
    near_ = point(place);
    complex.refresh_search();
  }

  [[nodiscard]] bool takes_the_point() {
    return crossing_point(complex, edge_, plane_, {0, 0, 0}, complex.weld_distance()) == near_;
  }

 private:
  Plane plane_;
  EdgeKey edge_ = 0;
  PointId near_ = 0;
};

TEST(CrossingPoint, IsTheOneAlongTheEdgeWhereTheAngleIsSmall) {
  EXPECT_TRUE(Crossing(0.1, {4 * kTolerance, 0, 0}).takes_the_point());
  EXPECT_TRUE(Crossing(0.1, {-4 * kTolerance, 0, 20}).takes_the_point());
}

TEST(CrossingPoint, IsANewOneWhereTheOtherIsOffThePlane) {
  EXPECT_FALSE(Crossing(0.1, {11 * kTolerance, 0, 0}).takes_the_point());
  EXPECT_FALSE(Crossing(0.5, {4 * kTolerance, 0, 0}).takes_the_point());
  EXPECT_FALSE(Crossing(0.1, {7 * kTolerance, 0, 20}).takes_the_point());
}

TEST(CrossingPoint, IsANewOneWhereTheOtherIsOffTheEdge) {
  EXPECT_FALSE(Crossing(0.1, {3 * kTolerance, 0, -40}).takes_the_point());
  EXPECT_FALSE(Crossing(1e-4, {20 * kTolerance, 0, 0}).takes_the_point());
}

TEST(CrossingPoint, IsWithinTheWeldDistanceAtAnyAngle) {
  EXPECT_TRUE(Crossing(1, {kTolerance, 0, 0}).takes_the_point());
  EXPECT_FALSE(Crossing(1, {2 * kTolerance, 0, 0}).takes_the_point());
}

}  // namespace
}  // namespace rad::repair
