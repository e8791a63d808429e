#include "scene/face_map.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene/scene_builder.h"

namespace rad::scene {
namespace {

constexpr geom::Lattice kLattice{0x1p-10, {0, 0, 0}};

dvec3 place_at(const Scene& scene, const FacePlace& place) {
  dvec3 sum(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) sum += scene.vertices[scene.corners[place.corner[i]]] * place.share[i];
  return sum;
}

Scene face_of(const std::vector<dvec3>& outer, const std::vector<dvec3>& hole = {}) {
  SceneBuilder builder("", "obj");
  std::vector<VertexId> ids;
  for (const dvec3& corner : outer) ids.push_back(builder.add_vertex(corner));
  builder.add_face(ids, 0);
  ids.clear();
  for (const dvec3& corner : hole) ids.push_back(builder.add_vertex(corner));
  if (!ids.empty()) builder.add_hole(ids);
  return builder.take();
}

void expect_places(const Scene& scene, const dvec3& point, const dvec3& expected) {
  const FacePlace place = FaceMap(scene, scene.faces[0], kLattice).nearest(point);
  double sum = 0;
  for (const double share : place.share) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
    sum += share;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(glm::distance(place_at(scene, place), expected), 0, 1e-12);
}

TEST(FaceMap, FindsPointsInsideATriangle) {
  const Scene triangle = face_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 2}});
  expect_places(triangle, {1, 0, 0}, {1, 0, 0});
  expect_places(triangle, {1, 1, 0.5}, {1, 1, 0.5});
}

TEST(FaceMap, TakesTheNearestPlaceOfPointsOutside) {
  const Scene triangle = face_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  expect_places(triangle, {1, 1, 7}, {1, 1, 0});
  expect_places(triangle, {2, -1, 0}, {2, 0, 0});
  expect_places(triangle, {9, -3, 0}, {4, 0, 0});
  expect_places(triangle, {3, 3, 0}, {2, 2, 0});
}

TEST(FaceMap, KeepsOutOfHolesAndNotches) {
  const Scene plate =
      face_of({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}});
  expect_places(plate, {1, 1, 0}, {1, 1, 0});
  expect_places(plate, {4, 4.5, 0}, {3, 4.5, 0});
  const Scene angle = face_of({{0, 0, 0}, {9, 0, 0}, {9, 2, 0}, {2, 2, 0}, {2, 9, 0}, {0, 9, 0}});
  expect_places(angle, {3, 8, 0}, {2, 8, 0});
}

TEST(FaceMap, TakesAFanWhereRingsCross) {
  const Scene bow = face_of({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}});
  expect_places(bow, {4, 2, 0}, {4, 2, 0});
}

TEST(FaceMap, OfATriangleWithoutAreaIsItsEdge) {
  expect_places(face_of({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}), {3, 1, 0}, {3, 0, 0});
  expect_places(face_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), {3, 1, 0}, {1, 1, 1});
}

// Sums must round alike wherever a loop starts, or shuffling a file would change what is written.
TEST(FaceMap, DoesNotDependOnTheFirstCorner) {
  const std::vector<dvec3> quad{{0.1, 0.2, 0}, {3.3, 0.7, 0}, {2.9, 4.1, 0}, {0.4, 3.7, 0}};
  const dvec3 point(1.234, 2.345, 0);
  std::vector<dvec3> places;
  for (std::size_t first = 0; first < 4; ++first) {
    std::vector<dvec3> turned;
    for (std::size_t i = 0; i < 4; ++i) turned.push_back(quad[(first + i) % 4]);
    const Scene scene = face_of(turned);
    places.push_back(place_at(scene, FaceMap(scene, scene.faces[0], kLattice).nearest(point)));
  }
  for (const dvec3& place : places) EXPECT_EQ(place, places[0]);
}

}  // namespace
}  // namespace rad::scene
