// Constrained Delaunay triangulations, their neighbours and their conflicts, against brute force.
#include "geom/planar_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using Points = std::vector<PlanarPoint>;
using Edge = std::array<std::uint32_t, 2>;
using Edges = std::vector<Edge>;

Int128 doubled_area(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return Int128{b.u - a.u} * (c.v - a.v) - Int128{b.v - a.v} * (c.u - a.u);
}

Int128 doubled_hull_area(Points points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Points hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const PlanarPoint& p : points) {
      while (hull.size() >= start + 2 && doubled_area(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  Int128 sum = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) sum += doubled_area(hull[0], hull[i], hull[i + 1]);
  return sum;
}

// Whether d is strictly inside the circle through a, b, c, which turn counter-clockwise.
bool in_circle(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) {
  const auto lifted = [&](const PlanarPoint& p) {
    return Int128{p.u - d.u} * (p.u - d.u) + Int128{p.v - d.v} * (p.v - d.v);
  };
  return lifted(a) * doubled_area(d, b, c) + lifted(b) * doubled_area(d, c, a) + lifted(c) * doubled_area(d, a, b) > 0;
}

std::uint32_t apex(const PlanarTriangle& t, int edge) { return t.corner[static_cast<std::size_t>((edge + 2) % 3)]; }

Edge ends(const PlanarTriangle& t, int edge) {
  const std::uint32_t a = t.corner[static_cast<std::size_t>(edge)],
                      b = t.corner[static_cast<std::size_t>((edge + 1) % 3)];
  return {std::min(a, b), std::max(a, b)};
}

// Counter-clockwise triangles that fill the hull and know each other across their edges.
void expect_sound(const PlanarMesh& mesh, const Points& points) {
  Int128 sum = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const PlanarTriangle& t = mesh.triangles[i];
    const Int128 area = doubled_area(points[t.corner[0]], points[t.corner[1]], points[t.corner[2]]);
    ASSERT_TRUE(area > 0);
    sum += area;
    for (int edge = 0; edge < 3; ++edge) {
      const std::uint32_t other = t.neighbour[static_cast<std::size_t>(edge)];
      if (other == kNoTriangle) continue;
      bool back = false;
      for (int k = 0; k < 3; ++k) {
        const PlanarTriangle& o = mesh.triangles[other];
        back |= o.neighbour[static_cast<std::size_t>(k)] == i && ends(o, k) == ends(t, edge) &&
                o.constrained[static_cast<std::size_t>(k)] == t.constrained[static_cast<std::size_t>(edge)];
      }
      ASSERT_TRUE(back) << "triangle " << i << " edge " << edge;
    }
  }
  ASSERT_TRUE(sum == doubled_hull_area(points));
}

void expect_locally_delaunay(const PlanarMesh& mesh, const Points& points) {
  for (const PlanarTriangle& t : mesh.triangles) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::uint32_t other = t.neighbour[static_cast<std::size_t>(edge)];
      if (other == kNoTriangle || t.constrained[static_cast<std::size_t>(edge)]) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t far = apex(mesh.triangles[other], k);
        ASSERT_FALSE(in_circle(points[t.corner[0]], points[t.corner[1]], points[t.corner[2]], points[far]));
      }
    }
  }
}

bool inside_segment(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  return p != a && p != b && doubled_area(a, b, p) == 0 && std::min(a, b) < p && p < std::max(a, b);
}

bool cross(const Points& points, const Edge& e, const Edge& f) {
  const PlanarPoint &a = points[e[0]], &b = points[e[1]], &c = points[f[0]], &d = points[f[1]];
  const auto sides = [](Int128 x, Int128 y) { return (x > 0 && y < 0) || (x < 0 && y > 0); };
  return sides(doubled_area(a, b, c), doubled_area(a, b, d)) && sides(doubled_area(c, d, a), doubled_area(c, d, b));
}

Points random_points(tests::LatticeRandom& random, std::int64_t count, std::int64_t reach, bool distinct) {
  std::set<PlanarPoint> seen;
  Points points;
  while (static_cast<std::int64_t>(points.size()) < count) {
    const std::int64_t u = random.between(-reach, reach);
    const PlanarPoint p{u, random.between(-reach, reach)};
    if (seen.insert(p).second || !distinct) points.push_back(p);
  }
  return points;
}

Edges random_edges(tests::LatticeRandom& random, const Points& points, std::int64_t count) {
  Edges edges;
  for (std::int64_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(random.between(0, static_cast<std::int64_t>(points.size()) - 1));
    const auto b = static_cast<std::uint32_t>(random.between(0, static_cast<std::int64_t>(points.size()) - 1));
    if (points[a] != points[b]) edges.push_back({a, b});
  }
  return edges;
}

TEST(PlanarMesh, OfFewPointsHasNoTriangle) {
  EXPECT_TRUE(constrained_delaunay({}, {}).triangles.empty());
  const Points on_a_line{{0, 0}, {1, 2}, {3, 6}, {-2, -4}};
  EXPECT_TRUE(constrained_delaunay(on_a_line, Edges{{0, 1}}).triangles.empty());
}

TEST(PlanarMesh, HasNoPointInAnyCircle) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    const std::int64_t reach = seed % 2 == 0 ? 4 : (1 << 25) - 1;  // many on one circle, or at the ends of the range
    const Points points = random_points(random, random.between(3, 25), reach, true);
    const PlanarMesh mesh = constrained_delaunay(points, {});
    ASSERT_TRUE(mesh.conflicts.none());
    expect_sound(mesh, points);
    for (const PlanarTriangle& t : mesh.triangles) {
      for (const PlanarPoint& p : points) {
        ASSERT_FALSE(in_circle(points[t.corner[0]], points[t.corner[1]], points[t.corner[2]], p));
      }
    }
  }
}

TEST(PlanarMesh, HoldsTheEdgesAskedFor) {
  const Points square{{0, 0}, {10, 0}, {10, 1}, {0, 1}, {5, -4}, {5, 5}};
  const PlanarMesh mesh = constrained_delaunay(square, Edges{{4, 5}});
  ASSERT_TRUE(mesh.conflicts.none());
  std::size_t found = 0;
  for (const PlanarTriangle& t : mesh.triangles) {
    for (int edge = 0; edge < 3; ++edge) {
      const bool asked = ends(t, edge) == Edge{4, 5};
      EXPECT_EQ(t.constrained[static_cast<std::size_t>(edge)], asked);
      found += asked ? 1 : 0;
    }
  }
  EXPECT_EQ(found, 2u);
}

TEST(PlanarMesh, TellsOfPointsAtOnePlace) {
  const Points points{{0, 0}, {9, 0}, {0, 9}, {9, 0}, {0, 0}, {9, 0}};
  const PlanarMesh mesh = constrained_delaunay(points, Edges{{4, 5}});
  auto coinciding = mesh.conflicts.coinciding;
  std::sort(coinciding.begin(), coinciding.end());
  EXPECT_EQ(coinciding, (Edges{{0, 4}, {1, 3}, {1, 5}}));
  expect_sound(mesh, points);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(std::ranges::count(mesh.triangles[0].constrained, true), 1);
}

TEST(PlanarMesh, TellsOfAPointOnAnEdge) {
  const Points points{{0, 0}, {8, 0}, {4, 0}, {4, 7}, {4, -7}};
  const PlanarMesh mesh = constrained_delaunay(points, Edges{{0, 1}});
  EXPECT_EQ(mesh.conflicts.point_on_edge, (Edges{{0, 2}}));
  EXPECT_TRUE(mesh.conflicts.crossing.empty());
  expect_sound(mesh, points);
}

TEST(PlanarMesh, LeavesOutAnEdgeThatCrossesAnEarlierOne) {
  const Points points{{0, 0}, {8, 8}, {8, 0}, {0, 8}};
  for (const Edges& edges : {Edges{{0, 1}, {2, 3}}, Edges{{2, 3}, {0, 1}}}) {
    const PlanarMesh mesh = constrained_delaunay(points, edges);
    EXPECT_EQ(mesh.conflicts.crossing, std::vector<std::uint32_t>{1});
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(std::ranges::count(mesh.triangles[0].corner, edges[0][0]) == 1 &&
                std::ranges::count(mesh.triangles[1].corner, edges[0][0]) == 1);
  }
}

TEST(PlanarMesh, ReportsAllConflictsAndNoOther) {
  std::size_t crossings = 0, on_edges = 0, coinciding = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    const Points points = random_points(random, random.between(4, 16), 4, false);
    const Edges edges = random_edges(random, points, random.between(1, 8));
    const PlanarMesh mesh = constrained_delaunay(points, edges);
    if (mesh.triangles.empty()) continue;
    expect_sound(mesh, points);
    expect_locally_delaunay(mesh, points);
    const std::set<PlanarPoint> places(points.begin(), points.end());
    ASSERT_EQ(mesh.conflicts.coinciding.size(), points.size() - places.size());
    const std::set<std::uint32_t> left_out(mesh.conflicts.crossing.begin(), mesh.conflicts.crossing.end());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      bool crosses_earlier = false, crosses_kept = false;
      for (std::uint32_t j = 0; j < i; ++j) {
        crosses_earlier |= cross(points, edges[i], edges[j]);
        crosses_kept |= cross(points, edges[i], edges[j]) && !left_out.contains(j);
      }
      ASSERT_TRUE(!left_out.contains(i) || crosses_earlier);
      ASSERT_TRUE(!crosses_kept || left_out.contains(i));
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        const bool on = inside_segment(points[p], points[edges[i][0]], points[edges[i][1]]);
        const bool told = std::ranges::count(mesh.conflicts.point_on_edge, Edge{i, p}) == 1;
        ASSERT_EQ(told, on && !left_out.contains(i));
        on_edges += told ? 1 : 0;
      }
    }
    crossings += left_out.size();
    coinciding += mesh.conflicts.coinciding.size();
  }
  EXPECT_GT(crossings, 100u);
  EXPECT_GT(on_edges, 100u);
  EXPECT_GT(coinciding, 100u);
}

// Rows, where most points lie on circles with others, and scattered ones; long edges run through many triangles.
TEST(PlanarMesh, IsSoundWithManyPointsAndEdges) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    const std::int64_t reach = seed % 3 == 0 ? 30 : (1 << 25) - 1;
    Points points = random_points(random, 1500, reach, true);
    if (seed % 3 == 1) {
      points.clear();
      for (std::int64_t i = 0; i < 1500; ++i) points.push_back({i % 500 * 1000, i / 500 * 7});
    }
    const PlanarMesh mesh = constrained_delaunay(points, random_edges(random, points, 200));
    expect_sound(mesh, points);
    expect_locally_delaunay(mesh, points);
    ASSERT_LT(mesh.conflicts.crossing.size(), 200u);
  }
}

// Whether the two triangles at the edge form a strictly convex quadrilateral.
bool can_flip(const PlanarMesh& mesh, const Points& points, std::uint32_t triangle, int edge) {
  const PlanarTriangle& t = mesh.triangles[triangle];
  const std::uint32_t other = t.neighbour[static_cast<std::size_t>(edge)];
  if (other == kNoTriangle || t.constrained[static_cast<std::size_t>(edge)]) return false;
  for (int k = 0; k < 3; ++k) {
    if (ends(mesh.triangles[other], k) != ends(t, edge)) continue;
    return cross(points, ends(t, edge), {apex(t, edge), apex(mesh.triangles[other], k)});
  }
  return false;
}

TEST(PlanarMesh, FlipKeepsNeighboursAndConstraints) {
  std::size_t flips = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    const Points points = random_points(random, random.between(4, 20), 8, true);
    PlanarMesh mesh = constrained_delaunay(points, random_edges(random, points, 2));
    if (mesh.triangles.empty()) continue;
    const auto constrained = [&] {
      std::set<Edge> edges;
      for (const PlanarTriangle& t : mesh.triangles) {
        for (int edge = 0; edge < 3; ++edge) {
          if (t.constrained[static_cast<std::size_t>(edge)]) edges.insert(ends(t, edge));
        }
      }
      return edges;
    };
    const std::set<Edge> before = constrained();
    for (int step = 0; step < 40; ++step) {
      const auto triangle =
          static_cast<std::uint32_t>(random.between(0, static_cast<std::int64_t>(mesh.triangles.size()) - 1));
      const auto edge = static_cast<int>(random.between(0, 2));
      if (!can_flip(mesh, points, triangle, edge)) continue;
      mesh.flip(triangle, edge);
      ++flips;
      expect_sound(mesh, points);
    }
    EXPECT_EQ(constrained(), before);
  }
  EXPECT_GT(flips, 500u);
}

}  // namespace
}  // namespace rad::geom
