// Triangulations cover what the rings enclose, exactly, and know which edges are the rings'.
#include "geom/constrained_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>

#include "geom/lattice.h"
#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using Ring = std::vector<std::uint32_t>;
using Rings = std::vector<Ring>;
using Points = std::vector<PlanarPoint>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::int64_t doubled_area(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

std::int64_t doubled_area(const Points& points, const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += doubled_area(points[ring[0]], points[ring[i]], points[ring[(i + 1) % ring.size()]]);
  }
  return sum;
}

Edge undirected(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::map<Edge, int> boundary_edges(const std::vector<PolygonTriangle>& triangles) {
  std::map<Edge, int> edges;
  for (const PolygonTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t.boundary[i]) ++edges[undirected(t.corners[i], t.corners[(i + 1) % 3])];
    }
  }
  return edges;
}

// Every triangle counter-clockwise; their area that of the rings.
std::int64_t covered(const Points& points, const std::vector<PolygonTriangle>& triangles) {
  std::int64_t sum = 0;
  for (const PolygonTriangle& t : triangles) {
    const std::int64_t area = doubled_area(points[t.corners[0]], points[t.corners[1]], points[t.corners[2]]);
    EXPECT_GT(area, 0);
    sum += area;
  }
  return sum;
}

// For rings that touch nowhere: the boundary edges are the edges of the rings, each on one triangle.
void expect_bounded_by(const Rings& rings, const std::vector<PolygonTriangle>& triangles) {
  std::map<Edge, int> expected;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) ++expected[undirected(ring[i], ring[(i + 1) % ring.size()])];
  }
  EXPECT_EQ(boundary_edges(triangles), expected);
}

// Adds a rectangle, counter-clockwise from its low corner.
Ring rectangle(Points& points, PlanarPoint low, PlanarPoint high) {
  const auto first = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), {low, {high.u, low.v}, high, {low.u, high.v}});
  return {first, first + 1, first + 2, first + 3};
}

TEST(Triangulation, OfATriangleIsTheTriangle) {
  const Points points{{0, 0}, {10, 0}, {0, 10}};
  for (const Ring& ring : {Ring{0, 1, 2}, Ring{2, 1, 0}}) {
    const auto triangles = triangulate_rings(points, Rings{ring});
    ASSERT_EQ(triangles.size(), 1U);
    EXPECT_EQ(covered(points, triangles), 100);
    expect_bounded_by({ring}, triangles);
  }
}

TEST(Triangulation, LeavesHolesOpenWhicheverWayTheyTurn) {
  Points points;
  const Ring outer = rectangle(points, {0, 0}, {100, 100});
  Ring hole = rectangle(points, {20, 30}, {50, 60});
  for (int turn = 0; turn < 2; ++turn) {
    const auto triangles = triangulate_rings(points, Rings{outer, hole});
    EXPECT_EQ(covered(points, triangles), 2 * (10000 - 900));
    EXPECT_EQ(triangles.size(), 8U) << "corners - 2 + 2 holes";
    expect_bounded_by({outer, hole}, triangles);
    std::reverse(hole.begin(), hole.end());
  }
}

TEST(Triangulation, FillsAnIslandInsideAHole) {
  Points points;
  Rings rings;
  for (std::int64_t i = 0; i < 5; ++i)
    rings.push_back(rectangle(points, {10 * i, 10 * i}, {100 - 10 * i, 100 - 10 * i}));
  const auto triangles = triangulate_rings(points, rings);
  EXPECT_EQ(covered(points, triangles), 2 * (10000 - 6400 + 3600 - 1600 + 400));
  expect_bounded_by(rings, triangles);
}

TEST(Triangulation, TakesManyHoles) {
  Points points;
  Rings rings{rectangle(points, {0, 0}, {1000, 1000})};
  for (std::int64_t u = 10; u < 1000; u += 50) {
    for (std::int64_t v = 10; v < 1000; v += 50) rings.push_back(rectangle(points, {u, v}, {u + 30, v + 30}));
  }
  const auto triangles = triangulate_rings(points, rings);
  EXPECT_EQ(covered(points, triangles), 2 * (1000000 - 400 * 900));
  expect_bounded_by(rings, triangles);
}

// One ring that runs to the hole and back along the same edge, as formats without holes write it.
TEST(Triangulation, FollowsABridgeToAHole) {
  Points points;
  rectangle(points, {0, 0}, {100, 100});
  rectangle(points, {20, 30}, {50, 60});
  const Ring bridged{0, 4, 7, 6, 5, 4, 0, 1, 2, 3};
  const auto triangles = triangulate_rings(points, Rings{bridged});
  EXPECT_EQ(covered(points, triangles), 2 * (10000 - 900));
  const auto edges = boundary_edges(triangles);
  ASSERT_TRUE(edges.contains({0, 4}));
  EXPECT_EQ(edges.at({0, 4}), 2) << "the bridge bounds a triangle on either side";
  EXPECT_EQ(edges.size(), 9U);
}

TEST(Triangulation, TakesRingsThatTouchInACorner) {
  Points points;
  const Ring outer = rectangle(points, {0, 0}, {100, 100});
  points.insert(points.end(), {{50, 30}, {60, 60}, {40, 60}, {30, 20}, {30, 60}});
  // Two holes that share corner 6, one of which touches the outline in corner 0.
  const Rings rings{outer, {4, 5, 6}, {0, 7, 6, 8}};
  const auto triangles = triangulate_rings(points, rings);
  std::int64_t expected = 20000;
  for (const Ring& hole : {rings[1], rings[2]}) expected -= std::abs(doubled_area(points, hole));
  EXPECT_EQ(covered(points, triangles), expected);
}

TEST(Triangulation, TakesAHoleThatTouchesTheOutlineFromInsideAnEdge) {
  Points points;
  const Ring outer = rectangle(points, {0, 0}, {100, 100});
  points.insert(points.end(), {{50, 0}, {60, 40}, {40, 40}});
  const auto triangles = triangulate_rings(points, Rings{outer, Ring{4, 5, 6}});
  EXPECT_EQ(covered(points, triangles), 20000 - 800);
  const auto edges = boundary_edges(triangles);
  EXPECT_TRUE(edges.contains({0, 4}) && edges.contains({1, 4})) << "the corner splits the edge";
  EXPECT_FALSE(edges.contains({0, 1}));
}

TEST(Triangulation, TakesAHoleThatRunsAlongTheOutline) {
  Points points;
  const Ring outer = rectangle(points, {0, 0}, {100, 100});
  const Ring hole = rectangle(points, {20, 0}, {70, 40});
  EXPECT_EQ(covered(points, triangulate_rings(points, Rings{outer, hole})), 2 * (10000 - 2000));
}

TEST(Triangulation, TakesAnOutlineThatTouchesItself) {
  // Two squares joined in corner 2.
  const Points points{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {20, 10}, {20, 20}, {10, 20}};
  const auto triangles = triangulate_rings(points, Rings{Ring{0, 1, 2, 4, 5, 6, 2, 3}});
  EXPECT_EQ(covered(points, triangles), 400);
  EXPECT_EQ(triangles.size(), 4U);
}

TEST(Triangulation, KeepsCornersInLine) {
  const Points points{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Ring ring{0, 1, 2, 3, 4};
  const auto triangles = triangulate_rings(points, Rings{ring});
  EXPECT_EQ(covered(points, triangles), 200);
  expect_bounded_by({ring}, triangles);
}

TEST(Triangulation, IsEmptyWhereEdgesCross) {
  const Points bow_tie{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  EXPECT_TRUE(triangulate_rings(bow_tie, Rings{Ring{0, 1, 2, 3}}).empty());
  Points points;
  const Ring outer = rectangle(points, {0, 0}, {100, 100});
  const Ring hole = rectangle(points, {50, 50}, {150, 70});
  EXPECT_TRUE(triangulate_rings(points, Rings{outer, hole}).empty());
}

TEST(Triangulation, IsEmptyWithoutArea) {
  EXPECT_TRUE(triangulate_rings({}, {}).empty());
  const Points line{{0, 0}, {5, 5}, {9, 9}};
  EXPECT_TRUE(triangulate_rings(line, Rings{Ring{0, 1, 2}}).empty());
  EXPECT_TRUE(triangulate_rings(std::span(line).first(1), Rings{Ring{0}}).empty());
}

// Corners at ascending angles around a centre: simple whatever the radii.
Points star(tests::LatticeRandom& random, std::uint32_t corners, double reach) {
  Points points;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.8 * random.unit()) / corners;
    const double radius = reach * (0.1 + 0.9 * random.unit());
    points.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return points;
}

TEST(Triangulation, CoversStarShapedPolygonsExactly) {
  tests::LatticeRandom random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const auto corners = static_cast<std::uint32_t>(random.between(3, 60));
    const Points points = star(random, corners, trial % 2 == 0 ? 1e5 : kLatticeLimit - 1.0);
    Ring ring(corners);
    for (std::uint32_t i = 0; i < corners; ++i) ring[i] = i;
    const std::int64_t area = doubled_area(points, ring);
    if (corners == 3 && area <= 0) continue;  // the centre is not inside
    std::rotate(ring.begin(), ring.begin() + random.between(0, corners - 1), ring.end());
    if (random.one_in(2)) std::reverse(ring.begin(), ring.end());
    const auto triangles = triangulate_rings(points, Rings{ring});
    ASSERT_EQ(covered(points, triangles), area);
    ASSERT_EQ(triangles.size(), corners - 2);
    expect_bounded_by({ring}, triangles);
  }
}

TEST(Triangulation, DoesNotDependOnWhereTheRingStarts) {
  tests::LatticeRandom random(2);
  const Points points = star(random, 40, 1e6);
  Ring ring(40);
  for (std::uint32_t i = 0; i < 40; ++i) ring[i] = i;
  const auto corner_sets = [&] {
    std::set<std::set<std::uint32_t>> sets;
    for (const auto& t : triangulate_rings(points, Rings{ring})) sets.emplace(t.corners.begin(), t.corners.end());
    return sets;
  };
  const auto expected = corner_sets();
  for (int start = 0; start < 40; ++start) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    ASSERT_EQ(corner_sets(), expected);
  }
}

// Region triangulation: a square with an edge that ends inside, and a point that no edge uses.
TEST(RegionTriangulation, KeepsInnerEdgesAndSinglePoints) {
  const Points points{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {20, 30}, {80, 35}, {50, 90}};
  const std::vector<PointEdge> outline{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, inner{{4, 5}};
  const auto triangles = triangulate_region(points, outline, inner);
  EXPECT_EQ(covered(points, triangles), 20000);
  EXPECT_EQ(triangles.size(), 2 * 7U - 2 - 4);
  const auto edges = boundary_edges(triangles);
  EXPECT_EQ(edges.at({4, 5}), 2) << "both sides know it";
  EXPECT_EQ(edges.size(), 5U);
  std::set<std::uint32_t> used;
  for (const auto& t : triangles) used.insert(t.corners.begin(), t.corners.end());
  EXPECT_TRUE(used.contains(6));
}

TEST(RegionTriangulation, LeavesOutPointsInHoles) {
  const Points points{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {20, 20}, {60, 20}, {60, 60}, {20, 60}, {40, 40}};
  const std::vector<PointEdge> outline{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const auto triangles = triangulate_region(points, outline, {});
  EXPECT_EQ(covered(points, triangles), 2 * (10000 - 1600));
  for (const auto& t : triangles) EXPECT_EQ(std::count(t.corners.begin(), t.corners.end(), 8U), 0);
}

TEST(RegionTriangulation, IsEmptyWhereAnInnerEdgeCrosses) {
  const Points points{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {50, 50}, {150, 60}};
  const std::vector<PointEdge> outline{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, inner{{4, 5}};
  EXPECT_TRUE(triangulate_region(points, outline, inner).empty());
}

}  // namespace
}  // namespace rad::geom
