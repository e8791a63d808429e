// Meetings of triangles against exact arithmetic, on lattices so small that they often touch.
#include "geom/triangle_meeting.h"

#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/exact_meeting.h"
#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using tests::ExactTriangle;
using tests::Meeting;
using Triangle = std::array<LatticePoint, 3>;

Triangle random_triangle(tests::LatticeRandom& random, std::int64_t reach, std::int64_t step) {
  while (true) {
    const Triangle t{random.grid_point(reach, step), random.grid_point(reach, step), random.grid_point(reach, step)};
    if (!collinear(t[0], t[1], t[2])) return t;
  }
}

std::vector<LatticePoint> common_corners(const Triangle& a, const Triangle& b) {
  std::vector<LatticePoint> common;
  for (const LatticePoint& p : a) {
    if (std::ranges::find(b, p) != b.end()) common.push_back(p);
  }
  return common;
}

// What the triangles have in common is measured against what their equal corners span.
bool meets_exactly(const Triangle& a, const Triangle& b) {
  const ExactTriangle exact_a(a), exact_b(b);
  const auto common = CGAL::intersection(exact_a.triangle(), exact_b.triangle());
  if (!common) return false;
  const std::vector<LatticePoint> corners = common_corners(a, b);
  if (corners.empty() || corners.size() == 3) return true;
  if (boost::get<ExactTriangle::Point>(&*common)) return false;  // only the equal corner: it is in both
  const auto* segment = boost::get<ExactTriangle::Segment>(&*common);
  if (!segment || corners.size() == 1) return true;
  const auto is_corner = [&](const ExactTriangle::Point& p) {
    return std::ranges::any_of(corners,
                               [&](const LatticePoint& c) { return p == ExactTriangle::Point(c.x, c.y, c.z); });
  };
  return !is_corner(segment->source()) || !is_corner(segment->target());
}

void expect_agreement(std::int64_t reach, std::int64_t step, int trials, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::map<std::pair<std::size_t, bool>, int> seen;
  for (int i = 0; i < trials; ++i) {
    const Triangle a = random_triangle(random, reach, step), b = random_triangle(random, reach, step);
    const bool expected = meets_exactly(a, b);
    ++seen[{common_corners(a, b).size(), expected}];
    ASSERT_EQ(meet_beyond_shared_corners(a, b), expected) << "trial " << i;
    ASSERT_EQ(meet_beyond_shared_corners(b, a), expected) << "trial " << i << " the other way";
  }
  for (const auto& [kind, count] : seen) EXPECT_GT(count, 0);
  EXPECT_GE(seen.size(), 2u);
}

TEST(TriangleMeeting, AgreesOnTheSmallestLattice) { expect_agreement(1, 1, 20000, 1); }
TEST(TriangleMeeting, AgreesOnASmallLattice) { expect_agreement(2, 1, 20000, 2); }
TEST(TriangleMeeting, AgreesOnALargeLattice) { expect_agreement(6, 1000000, 10000, 3); }

// Equal corners are rare at random, so they are forced.
TEST(TriangleMeeting, AgreesWithEqualCorners) {
  tests::LatticeRandom random(4);
  std::map<std::pair<std::size_t, bool>, int> seen;
  for (int i = 0; i < 20000; ++i) {
    const Triangle a = random_triangle(random, 2, 1);
    Triangle b = random_triangle(random, 2, 1);
    b[static_cast<std::size_t>(random.between(0, 2))] = a[static_cast<std::size_t>(random.between(0, 2))];
    if (random.one_in(2))
      b[static_cast<std::size_t>(random.between(0, 2))] = a[static_cast<std::size_t>(random.between(0, 2))];
    if (collinear(b[0], b[1], b[2])) continue;
    const bool expected = meets_exactly(a, b);
    ++seen[{common_corners(a, b).size(), expected}];
    ASSERT_EQ(meet_beyond_shared_corners(a, b), expected) << "trial " << i;
  }
  for (const std::size_t equal : {1u, 2u}) {
    for (const bool meets : {false, true}) EXPECT_GT((seen[{equal, meets}]), 100) << equal << ' ' << meets;
  }
}

TEST(TriangleMeeting, OfEqualTrianglesIsAMeeting) {
  const Triangle t{{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}}};
  EXPECT_TRUE(meet_beyond_shared_corners(t, {t[1], t[2], t[0]}));
  EXPECT_TRUE(meet_beyond_shared_corners(t, {t[0], t[2], t[1]}));
}

TEST(TriangleMeeting, FindsNoneBetweenNeighbours) {
  const LatticePoint a{0, 0, 0}, b{5, 0, 0}, c{0, 5, 0}, d{5, 5, 0};
  EXPECT_FALSE(meet_beyond_shared_corners({a, b, c}, {b, d, c}));
  EXPECT_FALSE(meet_beyond_shared_corners({a, b, c}, {a, b, {0, 0, 5}}));
  EXPECT_TRUE(meet_beyond_shared_corners({a, b, c}, {a, b, {1, 1, 0}}));
}

TEST(TriangleMeeting, SegmentsAgreeWithExactArithmetic) {
  tests::LatticeRandom random(5);
  std::array<int, 2> seen{};
  for (int i = 0; i < 20000; ++i) {
    const Triangle t = random_triangle(random, 2, 1);
    const LatticePoint from = random.grid_point(2, 1), to = random.grid_point(2, 1);
    if (from == to) continue;
    const ExactTriangle::Segment segment({from.x, from.y, from.z}, {to.x, to.y, to.z});
    const bool expected = CGAL::do_intersect(segment, ExactTriangle(t).triangle());
    ++seen[expected ? 1 : 0];
    ASSERT_EQ(segment_meets_triangle(from, to, t), expected) << "trial " << i;
  }
  EXPECT_GT(seen[0], 1000);
  EXPECT_GT(seen[1], 1000);
}

}  // namespace
}  // namespace rad::geom
