#include "geom/triangle_distance.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace rad::geom {
namespace {

constexpr std::array<LatticePoint, 3> kTriangle{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}};

TEST(NearestPoint, InsideOnAnEdgeAndAtACorner) {
  EXPECT_EQ(nearest_point(kTriangle, {2, 2, 5}), dvec3(2, 2, 0));
  EXPECT_EQ(nearest_point(kTriangle, {4, -3, 5}), dvec3(4, 0, 0));
  EXPECT_EQ(nearest_point(kTriangle, {8, 8, -1}), dvec3(4, 4, 0));
  EXPECT_EQ(nearest_point(kTriangle, {-1, -1, 0}), dvec3(0, 0, 0));
  EXPECT_EQ(nearest_point(kTriangle, {12, -1, 0}), dvec3(8, 0, 0));
}

TEST(NearestPoint, OfATriangleWithoutArea) {
  const std::array<LatticePoint, 3> line{{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}}};
  EXPECT_EQ(nearest_point(line, {6, 3, 0}), dvec3(6, 0, 0));
  const std::array<LatticePoint, 3> spot{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
  EXPECT_EQ(nearest_point(spot, {6, 3, 0}), dvec3(1, 1, 1));
}

TEST(NearestPoint, NoSampleOfTheTriangleIsNearer) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<std::int32_t>(random() % 200) - 100; };
  const auto point = [&] { return LatticePoint{coordinate(), coordinate(), coordinate()}; };
  for (int trial = 0; trial < 2000; ++trial) {
    const std::array<LatticePoint, 3> triangle{point(), point(), point()};
    const LatticePoint p = point();
    const double found = glm::distance(nearest_point(triangle, p), as_vector(p));
    double best = std::numeric_limits<double>::infinity();
    constexpr int kSteps = 24;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = double(i) / kSteps, v = double(j) / kSteps;
        const dvec3 sample =
            (1 - u - v) * as_vector(triangle[0]) + u * as_vector(triangle[1]) + v * as_vector(triangle[2]);
        best = std::min(best, glm::distance(sample, as_vector(p)));
      }
    }
    EXPECT_LE(found, best + 1e-9);
    EXPECT_GE(found, best - 300.0 / kSteps);
  }
}

}  // namespace
}  // namespace rad::geom
