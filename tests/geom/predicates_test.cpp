// Every predicate against the same question asked in integers without limit.
#include "geom/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using tests::LatticeRandom;

constexpr int kTrials = 20000;
constexpr std::int32_t kEnd = kLatticeLimit - 1;

struct Exact {
  cpp_int x, y, z;
};

Exact exact_difference(const LatticePoint& to, const LatticePoint& from) {
  return {cpp_int(to.x) - from.x, cpp_int(to.y) - from.y, cpp_int(to.z) - from.z};
}

Exact exact_cross(const Exact& a, const Exact& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

cpp_int exact_dot(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Sign exact_sign(const cpp_int& value) { return static_cast<Sign>(value.sign()); }

Exact exact_normal(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return exact_cross(exact_difference(b, a), exact_difference(c, a));
}

// Squared distance from the closed segment, with the foot as a fraction of it.
cpp_rational squared_distance_to_segment(const LatticePoint& p, const LatticePoint& from, const LatticePoint& to) {
  const Exact along = exact_difference(to, from), offset = exact_difference(p, from);
  const cpp_int squared_length = exact_dot(along, along);
  cpp_rational t = 0;
  if (squared_length != 0) t = cpp_rational(exact_dot(along, offset), squared_length);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const cpp_rational x = offset.x - t * along.x, y = offset.y - t * along.y, z = offset.z - t * along.z;
  return x * x + y * y + z * z;
}

bool exact_foot_inside(const LatticePoint& p, const LatticePoint& from, const LatticePoint& to, std::int64_t margin) {
  const Exact along = exact_difference(to, from);
  const cpp_int squared_length = exact_dot(along, along);
  if (squared_length == 0) return false;
  const cpp_rational t(exact_dot(along, exact_difference(p, from)), squared_length);
  const cpp_rational bound = cpp_rational(cpp_int(margin) * margin, squared_length);
  return t > 0 && t < 1 && t * t > bound && (1 - t) * (1 - t) > bound;
}

Sign exact_side(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& p,
                std::int64_t tolerance) {
  const Exact normal = exact_normal(a, b, c);
  const cpp_int value = exact_dot(normal, exact_difference(p, a));
  const bool within = value * value <= cpp_int(tolerance) * tolerance * exact_dot(normal, normal);
  return within ? Sign::Zero : exact_sign(value);
}

// A fourth point that is anything, in the plane of the three, or on a line through two of them.
LatticePoint related_point(LatticeRandom& random, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const auto blend = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    const std::int64_t sum = x + y - z;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(sum, -kEnd, kEnd));
  };
  switch (random.between(0, 4)) {
    case 0:
      return {blend(a.x, b.x, c.x), blend(a.y, b.y, c.y), blend(a.z, b.z, c.z)};
    case 1:
      return {blend(a.x, a.x, b.x), blend(a.y, a.y, b.y), blend(a.z, a.z, b.z)};
    case 2:
      return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    case 3:
      return a;
    default:
      return random.point();
  }
}

std::int64_t any_tolerance(LatticeRandom& random) {
  return random.one_in(3) ? random.between(0, 1 << 24) : random.between(0, 200);
}

TEST(Predicates, Orient3dAgreesWithIntegersWithoutLimit) {
  LatticeRandom random(1);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point(), c = random.point();
    const LatticePoint d = related_point(random, a, b, c);
    ASSERT_EQ(orient3d(a, b, c, d), exact_sign(exact_dot(exact_normal(a, b, c), exact_difference(d, a))));
  }
}

TEST(Predicates, Orient3dChangesSignWhereTwoPointsAreSwapped) {
  LatticeRandom random(2);
  for (int trial = 0; trial < kTrials / 4; ++trial) {
    std::array<LatticePoint, 4> p{random.point(), random.point(), random.point()};
    p[3] = related_point(random, p[0], p[1], p[2]);
    const Sign before = orient3d(p[0], p[1], p[2], p[3]);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        std::array<LatticePoint, 4> q = p;
        std::swap(q[i], q[j]);
        ASSERT_EQ(orient3d(q[0], q[1], q[2], q[3]), -before);
      }
    }
  }
}

TEST(Predicates, Orient2dAgreesWithIntegersWithoutLimitAndKeepsItsSymmetries) {
  LatticeRandom random(3);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint p = random.point(), q = random.point();
    const int dropped = static_cast<int>(random.between(0, 2));
    const PlanarPoint a = project(p, dropped), b = project(q, dropped);
    const PlanarPoint c = project(related_point(random, p, q, random.point()), dropped);
    const cpp_int area = (cpp_int(b.u) - a.u) * (cpp_int(c.v) - a.v) - (cpp_int(b.v) - a.v) * (cpp_int(c.u) - a.u);
    ASSERT_EQ(orient2d(a, b, c), exact_sign(area));
    ASSERT_EQ(orient2d(b, c, a), orient2d(a, b, c));
    ASSERT_EQ(orient2d(b, a, c), -orient2d(a, b, c));
  }
}

TEST(Predicates, ProjectionKeepsTheOrientationSeenFromThePositiveEndOfTheAxis) {
  LatticeRandom random(4);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point(), c = random.point();
    const IntVector normal = cross(difference(b, a), difference(c, a));
    const std::array<std::int64_t, 3> component{normal.x, normal.y, normal.z};
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(orient2d(project(a, axis), project(b, axis), project(c, axis)),
                sign_of(component[static_cast<std::size_t>(axis)]));
    }
  }
}

TEST(Predicates, DominantAxisIsTheFirstOfTheLargest) {
  EXPECT_EQ(dominant_axis({5, -5, 5}), 0);
  EXPECT_EQ(dominant_axis({-4, 5, -5}), 1);
  EXPECT_EQ(dominant_axis({1, 2, -3}), 2);
  EXPECT_EQ(dominant_axis({0, 0, 0}), 0);
  EXPECT_EQ(dominant_axis({-7, 7, 0}), 0);
}

TEST(Predicates, NormalsAndDotProductsFitTheirTypesAtTheEndsOfTheRange) {
  LatticeRandom random(5);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point(), c = random.point();
    const IntVector normal = cross(difference(b, a), difference(c, a));
    const Exact exact = exact_normal(a, b, c);
    ASSERT_EQ(cpp_int(normal.x), exact.x);
    ASSERT_EQ(cpp_int(normal.y), exact.y);
    ASSERT_EQ(cpp_int(normal.z), exact.z);
    ASSERT_EQ(cpp_int(dot(normal, normal)), exact_dot(exact, exact));
    const LatticePoint d = random.point();
    ASSERT_EQ(cpp_int(TrianglePlane(a, b, c).value(d)), exact_dot(exact, exact_difference(d, a)));
  }
}

TEST(Predicates, CollinearIsAZeroNormal) {
  LatticeRandom random(6);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point();
    const LatticePoint c = related_point(random, a, b, random.point());
    const Exact normal = exact_normal(a, b, c);
    const bool expected = normal.x == 0 && normal.y == 0 && normal.z == 0;
    ASSERT_EQ(collinear(a, b, c), expected);
    ASSERT_EQ(TrianglePlane(a, b, c).has_area(), !expected);
  }
}

TEST(Predicates, DistancesOfPointsAreExactToTheLastPitch) {
  LatticeRandom random(7);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point();
    const Exact between = exact_difference(b, a);
    const cpp_int squared = exact_dot(between, between);
    ASSERT_EQ(cpp_int(squared_distance(a, b)), squared);
    const auto root = static_cast<std::int64_t>(boost::multiprecision::sqrt(squared));
    for (std::int64_t tolerance = std::max<std::int64_t>(0, root - 1); tolerance <= root + 1; ++tolerance) {
      ASSERT_EQ(points_within(a, b, tolerance), squared <= cpp_int(tolerance) * tolerance);
    }
  }
  EXPECT_TRUE(points_within({0, 0, 0}, {3, 4, 12}, 13)) << "exactly at the tolerance";
  EXPECT_FALSE(points_within({0, 0, 0}, {3, 4, 13}, 13));
}

TEST(Predicates, DistanceFromSegmentIsExact) {
  LatticeRandom random(8);
  for (int trial = 0; trial < kTrials / 4; ++trial) {
    const LatticePoint from = random.point(), to = random.one_in(8) ? from : random.point();
    const LatticePoint p = related_point(random, from, to, random.point());
    const cpp_rational squared = squared_distance_to_segment(p, from, to);
    const auto floor =
        static_cast<std::int64_t>(boost::multiprecision::sqrt(cpp_int(numerator(squared) / denominator(squared))));
    for (const std::int64_t tolerance : {any_tolerance(random), floor, floor + 1}) {
      ASSERT_EQ(point_within_segment(p, from, to, tolerance), squared <= cpp_rational(cpp_int(tolerance) * tolerance));
    }
  }
}

TEST(Predicates, DistanceFromSegmentCountsEqualityAsWithin) {
  const LatticePoint from{-kEnd, -kEnd, 0}, to{kEnd, kEnd, 0};
  EXPECT_TRUE(point_within_segment({0, 0, 5}, from, to, 5));
  EXPECT_FALSE(point_within_segment({0, 0, 6}, from, to, 5));
  EXPECT_TRUE(point_within_segment({13, 0, 0}, {0, 0, 0}, {10, 0, 0}, 3)) << "beyond the end";
  EXPECT_FALSE(point_within_segment({14, 0, 0}, {0, 0, 0}, {10, 0, 0}, 3));
  EXPECT_TRUE(point_within_segment({2, 3, 6}, {0, 0, 0}, {0, 0, 0}, 7)) << "a segment of length 0";
  EXPECT_FALSE(point_within_segment({2, 3, 6}, {0, 0, 0}, {0, 0, 0}, 6));
}

TEST(Predicates, FootInsideSegmentIsExact) {
  LatticeRandom random(9);
  for (int trial = 0; trial < kTrials / 4; ++trial) {
    const LatticePoint from = random.point(), to = random.one_in(8) ? from : random.point();
    const LatticePoint p = related_point(random, from, to, random.point());
    const std::int64_t margin = any_tolerance(random);
    ASSERT_EQ(foot_inside_segment(p, from, to, margin), exact_foot_inside(p, from, to, margin));
    ASSERT_EQ(foot_inside_segment(p, to, from, margin), foot_inside_segment(p, from, to, margin));
  }
  EXPECT_FALSE(foot_inside_segment({5, 9, 9}, {0, 0, 0}, {20, 0, 0}, 5)) << "at the margin is not beyond it";
  EXPECT_TRUE(foot_inside_segment({6, 9, 9}, {0, 0, 0}, {20, 0, 0}, 5));
  EXPECT_FALSE(foot_inside_segment({15, 0, 0}, {0, 0, 0}, {20, 0, 0}, 5));
}

// Points around the height T over the triangle: two pitches on either side of where the band ends.
TEST(Predicates, SideOfPlaneIsExactAtTheEndOfTheBand) {
  LatticeRandom random(10);
  for (int trial = 0; trial < kTrials; ++trial) {
    const LatticePoint a = random.point(), b = random.point(), c = random.point();
    const TrianglePlane plane(a, b, c);
    if (!plane.has_area()) continue;
    const std::int64_t tolerance = random.between(1, 300);
    const double reach = static_cast<double>(tolerance) / plane.normal_length * (random.one_in(2) ? 1 : -1);
    const auto step = [&](std::int64_t n) {
      return std::llround(reach * static_cast<double>(n)) + random.between(-1, 1);
    };
    LatticePoint p = tests::moved_by(a, step(plane.normal.x), step(plane.normal.y), step(plane.normal.z));
    p = {std::clamp(p.x, -kEnd, kEnd), std::clamp(p.y, -kEnd, kEnd), std::clamp(p.z, -kEnd, kEnd)};
    const Sign expected = exact_side(a, b, c, p, tolerance);
    ASSERT_EQ(side_of_plane_within(plane, p, tolerance), expected);
    ASSERT_EQ(side_of_plane_within(TrianglePlane(b, c, a), p, tolerance), expected);
    ASSERT_EQ(side_of_plane_within(TrianglePlane(b, a, c), p, tolerance), -expected);
  }
}

TEST(Predicates, SideOfPlaneCountsEqualityAsWithin) {
  // Normals of whole length, so that distances are whole: (0 0 1), (3 4 0)/5, (2 3 6)/7.
  const TrianglePlane flat({-kEnd, -kEnd, 0}, {kEnd, -kEnd, 0}, {0, kEnd, 0});
  EXPECT_EQ(side_of_plane_within(flat, {7, 7, 50}, 50), Sign::Zero);
  EXPECT_EQ(side_of_plane_within(flat, {7, 7, 51}, 50), Sign::Positive);
  EXPECT_EQ(side_of_plane_within(flat, {7, 7, -51}, 50), Sign::Negative);
  const TrianglePlane upright({0, 0, 0}, {-4000000, 3000000, 0}, {0, 0, kEnd});
  EXPECT_EQ(side_of_plane_within(upright, {30, 40, 5}, 50), Sign::Zero);
  EXPECT_EQ(side_of_plane_within(upright, {31, 40, 5}, 50), Sign::Positive);
  EXPECT_EQ(side_of_plane_within(upright, {-31, -40, 5}, 50), Sign::Negative);
  const TrianglePlane oblique({0, 0, 0}, {3000000, -2000000, 0}, {0, 2000000, -1000000});
  EXPECT_EQ(side_of_plane_within(oblique, {20, 30, 60}, 70), Sign::Zero);
  EXPECT_NE(side_of_plane_within(oblique, {20, 30, 61}, 70), Sign::Zero);
}

TEST(Predicates, DistanceFromPlaneIsRoundedOnly) {
  const TrianglePlane plane({0, 0, 0}, {-4000000, 3000000, 0}, {0, 0, kEnd});
  EXPECT_DOUBLE_EQ(plane.distance({30, 40, 9}), 50);
  EXPECT_DOUBLE_EQ(plane.distance({-3, -4, 0}), -5);
}

}  // namespace
}  // namespace rad::geom
