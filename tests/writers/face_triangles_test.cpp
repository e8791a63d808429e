#include "writers/face_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene/scene_builder.h"
#include "tests/support/lattice_random.h"

namespace rad::writers {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::VertexId;
using ::testing::ElementsAre;

Scene polygon(const std::vector<dvec3>& corners) {
  scene::SceneBuilder builder("", "obj");
  std::vector<VertexId> ids;
  for (const dvec3& corner : corners) ids.push_back(builder.add_vertex(corner));
  builder.add_face(ids, 0);
  return builder.take();
}

std::vector<Triangle> split(const std::vector<dvec3>& corners) {
  const Scene scene = polygon(corners);
  const auto triangles = triangles_of(scene, scene.faces[0]);
  return triangles ? std::vector<Triangle>(triangles->begin(), triangles->end()) : std::vector<Triangle>();
}

const Triangle k012{0, 1, 2}, k023{0, 2, 3}, k123{1, 2, 3}, k130{1, 3, 0};

TEST(FaceTriangles, TakeTheDiagonalOfTheLargerSmallestAngle) {
  EXPECT_THAT(split({{0, 0, 0}, {3, 0, 0}, {4, 2, 0}, {1, 2, 0}}), ElementsAre(k123, k130)) << "the short one";
  EXPECT_THAT(split({{1, 0, 0}, {4, 0, 0}, {3, 2, 0}, {0, 2, 0}}), ElementsAre(k012, k023));
}

TEST(FaceTriangles, TakeTheDiagonalOfTheSmallestCornerInARectangle) {
  EXPECT_THAT(split({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}}), ElementsAre(k012, k023));
  EXPECT_THAT(split({{3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {0, 0, 0}}), ElementsAre(k123, k130));
  EXPECT_THAT(split({{0, 1, 0}, {0, 0, 1}, {5, 0, 1}, {5, 1, 0}}), ElementsAre(k123, k130)) << "y before z";
}

TEST(FaceTriangles, HaveAreaWhereACornerIsStraight) {
  EXPECT_THAT(split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 9, 0}}), ElementsAre(k123, k130));
  EXPECT_THAT(split({{1, 9, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), ElementsAre(k012, k023));
}

TEST(FaceTriangles, AreNoneForOtherFaces) {
  EXPECT_TRUE(split({{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_TRUE(split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty()) << "without area";
  EXPECT_TRUE(split({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty()) << "crosses itself";
  EXPECT_TRUE(split({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}).empty());
  Scene holed = polygon({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}});
  holed.loops = {{0, 3}, {3, 3}};
  holed.faces[0].loop_count = 2;
  EXPECT_FALSE(triangles_of(holed, holed.faces[0]));
}

// Any turn of the corners of a quad gives the same two triangles in space.
TEST(FaceTriangles, DoNotDependOnTheFirstCorner) {
  tests::LatticeRandom random(11);
  const auto sides = [](const std::vector<dvec3>& quad) {
    std::vector<std::array<double, 6>> diagonals;
    const auto triangles = split(quad);
    if (triangles.empty()) return diagonals;
    const dvec3 a = quad[triangles[0][0]], b = quad[triangles[0][2]];
    std::array<double, 6> ends{a.x, a.y, a.z, b.x, b.y, b.z}, turned{b.x, b.y, b.z, a.x, a.y, a.z};
    diagonals.push_back(std::min(ends, turned));
    return diagonals;
  };
  for (int i = 0; i < 2000; ++i) {
    const auto place = [&] { return dvec3(random.between(-20, 20), random.between(-20, 20), 3); };
    std::vector<dvec3> quad{place(), place(), place(), place()};
    const auto expected = sides(quad);
    for (int turn = 0; turn < 3; ++turn) {
      std::rotate(quad.begin(), quad.begin() + 1, quad.end());
      EXPECT_EQ(sides(quad), expected);
    }
  }
}

}  // namespace
}  // namespace rad::writers
