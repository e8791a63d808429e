#include "repair/leader_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/repair/drawn_soup.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 32;  // pitches

PlaneClaims claims_of(const Soup& soup) { return claim_planes(soup, kTolerance, kTolerance); }

LatticePoint rounded(double x, double y, double z) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y)),
          static_cast<std::int32_t>(std::lround(z))};
}

void expect_all_within_band(const Soup& soup, const PlaneClaims& claims) {
  ASSERT_EQ(claims.leader_of_piece.size(), soup.pieces.size());
  for (std::size_t i = 0; i < soup.pieces.size(); ++i) {
    const Plane& plane = claims.leaders[claims.leader_of_piece[i]].plane;
    for (const auto& edge : soup.edges_of(soup.pieces[i])) {
      EXPECT_LE(std::abs(plane.height(soup.points[edge[0]])), kTolerance + 1e-6);
    }
  }
}

TEST(LeaderPlanes, GivesAFloorOnePlane) {
  tests::SoupSketch sketch;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const int x = 1000 * i, y = 1000 * j;
      sketch.quad({x, y, 0}, {x + 1000, y, 0}, {x + 1000, y + 1000, 0}, {x, y + 1000, 0});
    }
  }
  const PlaneClaims claims = claims_of(sketch.take());
  ASSERT_EQ(claims.leaders.size(), 1u);
  EXPECT_DOUBLE_EQ(claims.leaders[0].area, 4e8);
  EXPECT_EQ(std::abs(claims.leaders[0].plane.normal.z), 1);
}

// Each facet is within T of the plane of its neighbour, but not of one two further on.
TEST(LeaderPlanes, DoNotCreepAroundACylinder) {
  tests::SoupSketch sketch;
  constexpr int kSides = 360;
  constexpr double kRadius = 50000;
  const auto at = [&](int i, double z) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    return rounded(kRadius * std::cos(angle), kRadius * std::sin(angle), z);
  };
  for (int i = 0; i < kSides; ++i) sketch.quad(at(i, 0), at(i + 1, 0), at(i + 1, 20000), at(i, 20000));
  const Soup soup = sketch.take();
  const PlaneClaims claims = claims_of(soup);
  expect_all_within_band(soup, claims);
  EXPECT_GE(claims.leaders.size(), kSides / 4);
}

// Tiles tilted by 0.2°, each against its neighbour: a strip that climbs like a wheel.
TEST(LeaderPlanes, DoNotDriftAlongATiltingFloor) {
  tests::SoupSketch sketch;
  constexpr double kTile = 2000, kTilt = 0.2 * std::numbers::pi / 180;
  double x = 0, z = 0;
  for (int i = 0; i < 100; ++i) {
    const double next_x = x + kTile * std::cos(kTilt * i), next_z = z + kTile * std::sin(kTilt * i);
    sketch.quad(rounded(x, 0, z), rounded(next_x, 0, next_z), rounded(next_x, kTile, next_z), rounded(x, kTile, z));
    x = next_x;
    z = next_z;
  }
  const Soup soup = sketch.take();
  const PlaneClaims claims = claims_of(soup);
  expect_all_within_band(soup, claims);
  EXPECT_GE(claims.leaders.size(), 10u);
  EXPECT_LE(claims.leaders.size(), 60u);
}

TEST(LeaderPlanes, TakeWhatLooksTheOtherWay) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  sketch.triangle({0, 0, 20}, {0, 900, 20}, {900, 0, 20});
  EXPECT_EQ(claims_of(sketch.take()).leaders.size(), 1u);
}

TEST(LeaderPlanes, LeaveWhatIsOutsideTheBand) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  sketch.triangle({0, 0, 33}, {900, 0, 33}, {0, 900, 33});
  EXPECT_EQ(claims_of(sketch.take()).leaders.size(), 2u);
}

TEST(LeaderPlanes, DoNotReachOverAGap) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  sketch.triangle({5000, 0, 0}, {5900, 0, 0}, {5000, 900, 0});
  const PlaneClaims claims = claims_of(sketch.take());
  EXPECT_EQ(claims.leaders.size(), 2u);
}

TEST(LeaderPlanes, LetTheLargestLead) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 10}, {100, 0, 10}, {0, 100, 10});
  sketch.triangle({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  const PlaneClaims claims = claims_of(sketch.take());
  ASSERT_EQ(claims.leaders.size(), 1u);
  EXPECT_EQ(claims.leaders[0].plane.offset, 0);
}

// A sheet as small as T must not lie down on the floor that it stands on.
TEST(LeaderPlanes, LeaveASmallUprightTriangle) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  sketch.triangle({100, 100, 0}, {130, 100, 0}, {100, 100, 30});
  EXPECT_EQ(claims_of(sketch.take()).leaders.size(), 2u);
}

TEST(LeaderPlanes, OfNothingAreNone) { EXPECT_TRUE(claims_of({}).leaders.empty()); }

}  // namespace
}  // namespace rad::repair
