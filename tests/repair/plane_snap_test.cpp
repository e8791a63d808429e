#include "repair/plane_snap.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/repair/drawn_soup.h"
#include "tests/support/lattice_random.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 40;  // pitches

struct Snapped {
  Soup before, after;
  SnapCounts counts;

  explicit Snapped(const tests::SoupSketch& sketch) : before(sketch.take()), after(before) {
    counts = snap_to_planes(after, claim_planes(before, kTolerance, kTolerance), kTolerance);
  }
};

TEST(PlaneSnap, MovesNothingWithinAQuarterOfT) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {9000, 0, 0}, {0, 9000, 0});
  sketch.triangle({100, 100, 10}, {4000, 100, -10}, {100, 4000, 10});
  const Snapped snapped(sketch);
  EXPECT_EQ(snapped.after.points, snapped.before.points);
  EXPECT_EQ(snapped.counts.moved, 0u);
}

TEST(PlaneSnap, LaysASheetOnTheFloorThatItHovers) {
  tests::SoupSketch sketch;
  sketch.triangle({0, 0, 0}, {9000, 0, 0}, {0, 9000, 0});
  sketch.triangle({100, 100, 30}, {4000, 100, 30}, {100, 4000, 30});
  const Snapped snapped(sketch);
  for (const LatticePoint& point : snapped.after.points) EXPECT_EQ(point.z, 0);
  EXPECT_EQ(snapped.counts.moved, 3u);
  EXPECT_EQ(snapped.counts.largest, 30);
}

// The foot of a wall is in its own plane and in the floor's.
TEST(PlaneSnap, BringsTheFootOfAWallIntoBothPlanes) {
  tests::SoupSketch sketch;
  sketch.quad({-9000, -9000, 0}, {9000, -9000, 0}, {9000, 9000, 0}, {-9000, 9000, 0});
  sketch.quad({-4000, 0, 25}, {4000, 0, 25}, {4000, 3000, 4025}, {-4000, 3000, 4025});
  const Snapped snapped(sketch);
  EXPECT_EQ(snapped.counts.moved, 2u);
  const PlaneClaims claims = claim_planes(snapped.before, kTolerance, kTolerance);
  const Plane& wall = claims.leaders[claims.leader_of_piece[2]].plane;
  for (PointId id = 4; id < 6; ++id) {
    EXPECT_EQ(snapped.after.points[id].z, 0);
    EXPECT_LE(std::abs(wall.height(snapped.after.points[id])), 1);
  }
}

// A corner of a room: three planes, and a fourth one that it cannot satisfy too.
TEST(PlaneSnap, UsesThreePlanesAtMost) {
  tests::SoupSketch sketch;
  sketch.triangle({20, 20, 20}, {9000, 20, 20}, {20, 9000, 20});
  sketch.triangle({0, 25, 20}, {0, 8000, 20}, {0, 25, 8020});
  sketch.triangle({20, 0, 20}, {20, 0, 7020}, {7020, 0, 20});
  sketch.triangle({20, 20, 20}, {6020, 20, 20}, {20, 6000, 2020});
  const Snapped snapped(sketch);
  EXPECT_LE(snapped.counts.largest, kSnapBudget * kTolerance + 1);
  EXPECT_EQ(snapped.after.points[0], (LatticePoint{0, 0, 20}));
}

TEST(PlaneSnap, KeepsWithinItsBudget) {
  tests::LatticeRandom random(5);
  std::size_t moved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    tests::SoupSketch sketch;
    for (int i = 0; i < 12; ++i) {
      const auto corner = [&] {
        const LatticePoint p = random.grid_point(3, 1000);
        return tests::moved_by(p, random.between(-40, 40), random.between(-40, 40), random.between(-40, 40));
      };
      const LatticePoint a = corner(), b = corner(), c = corner();
      if (!geom::collinear(a, b, c)) sketch.triangle(a, b, c);
    }
    Snapped snapped(sketch);
    moved += snapped.counts.moved;
    for (std::size_t i = 0; i < snapped.before.points.size(); ++i) {
      const double way =
          glm::distance(geom::as_vector(snapped.before.points[i]), geom::as_vector(snapped.after.points[i]));
      EXPECT_LE(way, kSnapBudget * kTolerance + 1);  // the last step to the lattice is below one pitch
      EXPECT_LE(way, snapped.counts.largest);
    }
  }
  EXPECT_GT(moved, 100u);
}

}  // namespace
}  // namespace rad::repair
