#include "bake/display_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scene_invariants.h"

namespace rad::bake {
namespace {

using ::testing::ElementsAre;

scene::Scene named_origin() {
  scene::Scene origin = scene::empty_scene("room.obj", "obj");
  origin.materials.push_back({.name = "paint"});
  origin.objects.push_back("chair");
  origin.groups.push_back("seat");
  origin.metres_per_unit = 0.01;
  origin.up = scene::UpAxis::Y;
  origin.single_precision = true;
  return origin;
}

TEST(DisplayScene, TriangleAndQuadrilateral_KeepOrderAndNames) {
  mesh::DisplayMesh display;
  for (const geom::LatticePoint& point :
       {geom::LatticePoint{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {8, 2, 0}, {4, 0, 0}}) {
    display.vertices.push_back({.point = point});
  }
  display.faces.push_back({.corner = {0, 1, 2, 3}, .count = 4, .material = 1, .object = 1, .group = 1});
  display.faces.push_back({.corner = {5, 4, 2, 0}, .count = 3});
  const geom::Lattice lattice{.pitch = 0.5, .origin = {10, 20, 30}};
  const scene::Scene scene = display_scene(display, lattice, named_origin());

  EXPECT_EQ(tests::broken_invariant(scene), "");
  ASSERT_EQ(scene.vertices.size(), 6u);
  EXPECT_EQ(scene.vertices[4], geom::dvec3(14, 21, 30));
  EXPECT_EQ(scene.vertices[1], scene.vertices[5]) << "vertices of two surfaces stay two";
  ASSERT_EQ(scene.faces.size(), 2u);
  EXPECT_THAT(scene.corners_of(scene.loops[0]), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(scene.corners_of(scene.loops[1]), ElementsAre(5, 4, 2));
  EXPECT_EQ(scene.faces[0].material, 1u);
  EXPECT_EQ(scene.faces[0].object, 1u);
  EXPECT_EQ(scene.faces[0].group, 1u);
  EXPECT_EQ(scene.materials[1].name, "paint");
  EXPECT_EQ(scene.objects[1], "chair");
  EXPECT_EQ(scene.groups[1], "seat");
  EXPECT_EQ(scene.metres_per_unit, 0.01);
  EXPECT_EQ(scene.up, scene::UpAxis::Y);
  EXPECT_FALSE(scene.single_precision) << "positions are lattice points, not floats of a file";
}

TEST(DisplayScene, NoFaces_EmptyScene) {
  const scene::Scene scene = display_scene({}, {}, named_origin());
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_TRUE(scene.vertices.empty());
  EXPECT_TRUE(scene.faces.empty());
}

}  // namespace
}  // namespace rad::bake
