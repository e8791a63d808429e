#include "bake/scene_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "tests/bake/drawn_scenes.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::SceneBuilder;
using scene::VertexId;

dvec3 doubled_area(const Scene& scene, const DrawnTriangle& triangle) {
  const dvec3& a = scene.vertices[triangle.corners[0]];
  return glm::cross(scene.vertices[triangle.corners[1]] - a, scene.vertices[triangle.corners[2]] - a);
}

double area_up(const Scene& scene) {
  double sum = 0;
  for (const DrawnTriangle& triangle : drawn_triangles(scene)) sum += doubled_area(scene, triangle).z / 2;
  return sum;
}

int outline_edges(const std::vector<DrawnTriangle>& triangles) {
  int count = 0;
  for (const DrawnTriangle& triangle : triangles) {
    for (const bool outline : triangle.outline) count += outline;
  }
  return count;
}

TEST(DrawnTriangles, ConvexQuadrilateral_SplitAlongTheShorterDiagonal) {
  for (const std::size_t turn : {0u, 1u}) {
    std::vector<dvec3> points{{0, 0, 0}, {3, -1, 0}, {4, 0, 0}, {3, 1, 0}};
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(turn), points.end());
    SceneBuilder builder("kite.obj", "obj");
    tests::add_polygon(builder, points);
    const auto triangles = drawn_triangles(builder.scene());
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_EQ(outline_edges(triangles), 4);
    for (const DrawnTriangle& triangle : triangles) {
      const dvec3& from = builder.scene().vertices[triangle.corners[2]];
      const dvec3& to = builder.scene().vertices[triangle.corners[0]];
      EXPECT_FALSE(triangle.outline[2]);
      EXPECT_EQ(glm::distance(from, to), 2) << "the diagonal";
    }
    EXPECT_DOUBLE_EQ(area_up(builder.scene()), 4);
  }
}

TEST(DrawnTriangles, ConcaveQuadrilateral_StaysInside) {
  SceneBuilder builder("dart.obj", "obj");
  tests::add_polygon(builder, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
  for (const DrawnTriangle& triangle : drawn_triangles(builder.scene())) {
    EXPECT_GT(doubled_area(builder.scene(), triangle).z, 0);
  }
  EXPECT_DOUBLE_EQ(area_up(builder.scene()), 4);
}

TEST(DrawnTriangles, FaceWithHole_LeavesItOpenWhicheverWayItFaces) {
  for (const bool turned : {false, true}) {
    SceneBuilder builder("plate.obj", "obj");
    std::vector<VertexId> outer, hole;
    for (const dvec3& p : {dvec3{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}) outer.push_back(builder.add_vertex(p));
    for (const dvec3& p : {dvec3{1, 1, 1}, {1, 2, 1}, {2, 2, 1}, {2, 1, 1}}) hole.push_back(builder.add_vertex(p));
    if (turned) {
      std::reverse(outer.begin(), outer.end());
      std::reverse(hole.begin(), hole.end());
    }
    builder.add_face(outer, 0);
    builder.add_hole(hole);
    EXPECT_DOUBLE_EQ(area_up(builder.scene()), turned ? -15 : 15);
    EXPECT_EQ(outline_edges(drawn_triangles(builder.scene())), 8);
  }
}

TEST(DrawnTriangles, BadFaces_AreShownOrLeftOut) {
  SceneBuilder builder("bad.obj", "obj");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  tests::add_polygon(builder, {{0, 0, 0}, {1, 0, 0}, {0, nan, 0}});
  tests::add_polygon(builder, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_TRUE(drawn_triangles(builder.scene()).empty());
  tests::add_polygon(builder, {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}});
  EXPECT_EQ(drawn_triangles(builder.scene()).size(), 2u) << "a bow tie as a fan";
}

}  // namespace
}  // namespace rad::bake
