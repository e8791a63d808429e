// Questions about rings, by hand and against brute force.
#include "validate/rings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/lattice_random.h"

namespace rad::validate {
namespace {

using geom::PlanarPoint;
using Points = std::vector<PlanarPoint>;
using Rings = std::vector<Ring>;

Ring in_order(std::size_t count) {
  Ring ring(count);
  for (std::uint32_t i = 0; i < count; ++i) ring[i] = i;
  return ring;
}

bool crosses(const Points& points) { return edges_cross(points, Rings{in_order(points.size())}); }
bool convex(const Points& points, bool strict) { return is_convex(points, in_order(points.size()), strict); }

TEST(EdgesCross, OnlyInTheInsideOfBoth) {
  EXPECT_FALSE(crosses({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_TRUE(crosses({{0, 0}, {4, 4}, {4, 0}, {0, 4}})) << "bow tie";
  EXPECT_FALSE(crosses({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}})) << "touching itself in a corner";
  EXPECT_FALSE(crosses({{0, 0}, {8, 0}, {8, 4}, {4, 0}, {0, 4}})) << "a corner on an edge";
  EXPECT_FALSE(crosses({}));
}

TEST(EdgesCross, RunningAlongEachOtherIsNotCrossing) {
  const Points points{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {2, 2}, {2, 6}, {6, 6}, {6, 2}};
  EXPECT_FALSE(edges_cross(points, Rings{{0, 4, 5, 6, 7, 4, 0, 1, 2, 3}})) << "bridge to a hole";
  EXPECT_FALSE(crosses({{0, 0}, {8, 0}, {4, 0}, {4, 4}})) << "spike";
}

TEST(EdgesCross, BetweenRings) {
  const Points points{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {5, 5}, {5, 20}, {6, 5}};
  EXPECT_TRUE(edges_cross(points, Rings{{0, 1, 2, 3}, {4, 5, 6}}));
  EXPECT_FALSE(edges_cross(points, Rings{{0, 1, 2, 3}}));
}

TEST(EdgesCross, AgreesWithEveryPairOfEdges) {
  tests::LatticeRandom random(1);
  int crossing = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Points points(static_cast<std::size_t>(random.between(3, 9)));
    for (PlanarPoint& p : points) p = {random.between(-20, 20), random.between(-20, 20)};
    const std::size_t n = points.size();
    bool expected = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const PlanarPoint &a = points[i], &b = points[(i + 1) % n], &c = points[j], &d = points[(j + 1) % n];
        const int product_ab = static_cast<int>(orient2d(a, b, c)) * static_cast<int>(orient2d(a, b, d));
        const int product_cd = static_cast<int>(orient2d(c, d, a)) * static_cast<int>(orient2d(c, d, b));
        expected = expected || (product_ab < 0 && product_cd < 0);
      }
    }
    crossing += expected ? 1 : 0;
    ASSERT_EQ(crosses(points), expected);
  }
  EXPECT_GT(crossing, 100);
  EXPECT_LT(crossing, 2900);
}

TEST(IsConvex, WhicheverWayItTurns) {
  EXPECT_TRUE(convex({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true));
  EXPECT_TRUE(convex({{0, 0}, {0, 4}, {4, 4}, {4, 0}}, true));
  EXPECT_FALSE(convex({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, false)) << "reflex corner";
  EXPECT_FALSE(convex({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, false)) << "bow tie";
}

TEST(IsConvex, CornersInLineAreConvexButNotStrictly) {
  const Points points{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_TRUE(convex(points, false));
  EXPECT_FALSE(convex(points, true));
}

TEST(IsConvex, NeitherSpikesNorPolygramsNorLinesAre) {
  EXPECT_FALSE(convex({{0, 0}, {8, 0}, {4, 0}, {4, 4}}, false)) << "backward in line";
  EXPECT_FALSE(convex({{0, 0}, {4, 0}, {8, 0}}, false)) << "no turn at all";
  EXPECT_FALSE(convex({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}, false)) << "pentagram turns twice around";
  EXPECT_FALSE(convex({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, false)) << "twice around";
}

TEST(InsideOrOn, CountsTheOutlineAsInside) {
  const Points points{{0, 0}, {8, 0}, {8, 8}, {4, 2}, {0, 8}};
  const Ring ring = in_order(5);
  for (const PlanarPoint& p : points) EXPECT_TRUE(inside_or_on(points, ring, p));
  EXPECT_TRUE(inside_or_on(points, ring, {4, 0}));
  EXPECT_TRUE(inside_or_on(points, ring, {6, 5})) << "on the slanted edge";
  EXPECT_TRUE(inside_or_on(points, ring, {1, 1}));
  EXPECT_FALSE(inside_or_on(points, ring, {4, 5})) << "in the notch";
  EXPECT_FALSE(inside_or_on(points, ring, {-1, 0})) << "in line with an edge";
  EXPECT_FALSE(inside_or_on(points, ring, {9, 8})) << "level with a corner";
}

TEST(InsideOrOn, DoesNotDependOnTheStartOrSenseOfTheRing) {
  tests::LatticeRandom random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    Points points(static_cast<std::size_t>(random.between(3, 8)));
    for (PlanarPoint& p : points) p = {random.between(-9, 9), random.between(-9, 9)};
    const PlanarPoint asked{random.between(-9, 9), random.between(-9, 9)};
    Ring ring = in_order(points.size());
    const bool expected = inside_or_on(points, ring, asked);
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    ASSERT_EQ(inside_or_on(points, ring, asked), expected);
    std::reverse(ring.begin(), ring.end());
    ASSERT_EQ(inside_or_on(points, ring, asked), expected);
  }
}

}  // namespace
}  // namespace rad::validate
