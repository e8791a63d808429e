#include "scene/repaired_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "scene/scene_builder.h"
#include "tests/support/scene_invariants.h"

namespace rad::scene {
namespace {

using ::testing::ElementsAre;

/// A square of side 8 with a triangular hole, an unused point before it and a point inside its triangulation.
ConformingModel square_with_hole() {
  ConformingModel model;
  model.lattice = {.pitch = 0.25, .origin = {1, 0, 0}};
  model.tolerance.length = 2;
  model.points = {{-9, 0, 0}, {0, 0, 0}, {0, 8, 0}, {2, 2, 0}, {2, 4, 0}, {4, 2, 0}, {6, 6, 0}, {8, 0, 0}, {8, 8, 0}};
  model.corners = {1, 7, 8, 2, 3, 4, 5};
  model.loops = {{0, 4}, {4, 3}};
  model.triangles = {{1, 7, 5}, {1, 5, 3}, {1, 3, 2}, {3, 4, 2}, {4, 6, 2}, {4, 5, 6}, {5, 7, 6}, {7, 8, 6}, {8, 2, 6}};
  model.faces.push_back({.first_loop = 0,
                         .loop_count = 2,
                         .first_triangle = 0,
                         .triangle_count = 9,
                         .material = 1,
                         .object = 1,
                         .source = 1});
  return model;
}

Scene origin() {
  SceneBuilder builder("plate.obj", "obj");
  builder.add_section({.file = "plate.obj", .pointer = {}, .kind = RecordKind::Line});
  for (int i = 0; i < 3; ++i) builder.add_vertex({i, i * i, 0});
  builder.use_material(builder.material("paint"));
  builder.use_object(builder.object("plate"));
  builder.add_face(std::array<VertexId, 3>{0, 1, 2}, 7);
  builder.add_face(std::array<VertexId, 3>{0, 2, 1}, 8);
  Scene scene = builder.take();
  scene.metres_per_unit = 0.001;
  scene.up = UpAxis::Z;
  return scene;
}

TEST(RepairedScene, Faces_KeepLoopsAndDropUnusedPoints) {
  const Scene scene = repaired_scene(square_with_hole(), origin(), Pieces::Faces);
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_EQ(scene.vertices.size(), 7u) << "neither the unused point nor the one inside";
  EXPECT_EQ(scene.vertices[0], dvec3(1, 0, 0));
  ASSERT_EQ(scene.faces.size(), 1u);
  ASSERT_EQ(scene.faces[0].loop_count, 2u);
  EXPECT_THAT(scene.corners_of(scene.loops[0]), ElementsAre(0, 5, 6, 1));
  EXPECT_THAT(scene.corners_of(scene.loops[1]), ElementsAre(2, 3, 4));
}

TEST(RepairedScene, Triangles_UseThePointsInside) {
  const Scene scene = repaired_scene(square_with_hole(), origin(), Pieces::Triangles);
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_EQ(scene.vertices.size(), 8u);
  ASSERT_EQ(scene.faces.size(), 9u);
  EXPECT_THAT(scene.corners_of(scene.loops[3]), ElementsAre(2, 3, 1)) << "the fourth in the order of space";
  EXPECT_EQ(scene.vertices[5], dvec3(2.5, 1.5, 0));
}

TEST(RepairedScene, WhatIsKeptOfTheOrigin) {
  for (const Pieces pieces : {Pieces::Faces, Pieces::Triangles}) {
    const Scene scene = repaired_scene(square_with_hole(), origin(), pieces);
    for (const Face& face : scene.faces) {
      EXPECT_EQ(scene.materials[face.material].name, "paint");
      EXPECT_EQ(scene.objects[face.object], "plate");
      EXPECT_EQ(face.source.record, 8u);
      EXPECT_EQ(scene.sections[face.source.section].file, "plate.obj");
    }
    EXPECT_EQ(scene.metres_per_unit, 0.001);
    EXPECT_EQ(scene.up, UpAxis::Z);
    ASSERT_TRUE(scene.recorded.has_value());
    EXPECT_EQ(scene.recorded->tolerance, 2);
    EXPECT_EQ(scene.recorded->lattice.pitch, 0.25);
  }
}

}  // namespace
}  // namespace rad::scene
