// The builder keeps the invariants of a scene, whatever arrives.
#include "scene/scene_builder.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/scene_invariants.h"

namespace rad::scene {
namespace {

using Ids = std::vector<VertexId>;

// A builder with one section and four vertices.
SceneBuilder builder_with_square() {
  SceneBuilder builder("room.obj", "obj");
  builder.add_section({"room.obj", "", RecordKind::Line});
  for (const dvec3& p : {dvec3{0, 0, 0}, dvec3{1, 0, 0}, dvec3{1, 1, 0}, dvec3{0, 1, 0}}) builder.add_vertex(p);
  return builder;
}

TEST(EmptyScene, HasTheUnnamedMaterialObjectAndGroup) {
  const Scene scene = empty_scene("a.ply", "ply");
  EXPECT_EQ(scene.path, "a.ply");
  EXPECT_EQ(scene.format, "ply");
  EXPECT_EQ(scene.materials.size(), 1U);
  EXPECT_FALSE(scene.materials[0].reflectance_stated);
  EXPECT_FALSE(scene.materials[0].emits());
  EXPECT_EQ(scene.objects, std::vector<std::string>{""});
  EXPECT_EQ(scene.groups, std::vector<std::string>{""});
  EXPECT_EQ(tests::broken_invariant(scene), "");
}

TEST(SceneBuilder, NumbersNamesOnFirstUse) {
  SceneBuilder builder("a.obj", "obj");
  EXPECT_EQ(builder.object(""), 0U);
  EXPECT_EQ(builder.object("chair"), 1U);
  EXPECT_EQ(builder.object("table"), 2U);
  EXPECT_EQ(builder.object("chair"), 1U);
  EXPECT_EQ(builder.group("chair"), 1U) << "groups count by themselves";
  EXPECT_EQ(builder.material("oak"), 1U);
  EXPECT_EQ(builder.material(""), 0U);
  builder.material_at(1).emission = {0, 2, 0};
  const Scene scene = builder.take();
  EXPECT_EQ(scene.objects, (std::vector<std::string>{"", "chair", "table"}));
  EXPECT_EQ(scene.materials[1].name, "oak");
  EXPECT_TRUE(scene.materials[1].emits());
}

TEST(SceneBuilder, FacesBelongToWhatIsInUse) {
  SceneBuilder builder = builder_with_square();
  builder.use_object(builder.object("box"));
  builder.use_group(builder.group("lid"));
  builder.use_material(builder.material("oak"));
  EXPECT_EQ(builder.add_face(Ids{0, 1, 2, 3}, 17), 0U);
  builder.use_material(0);
  builder.add_section({"other.obj", "/meshes/0", RecordKind::Element});
  EXPECT_EQ(builder.add_face(Ids{0, 1, 2}, 4), 1U);
  const Scene scene = builder.take();
  EXPECT_EQ(scene.faces[0].object, 1U);
  EXPECT_EQ(scene.faces[0].group, 1U);
  EXPECT_EQ(scene.faces[0].material, 1U);
  EXPECT_EQ(scene.faces[0].source.section, 0U);
  EXPECT_EQ(scene.faces[0].source.record, 17U);
  EXPECT_EQ(scene.faces[1].material, 0U);
  EXPECT_EQ(scene.faces[1].object, 1U);
  EXPECT_EQ(scene.faces[1].source.section, 1U);
  EXPECT_EQ(tests::broken_invariant(scene), "");
}

TEST(SceneBuilder, HolesJoinTheFaceAddedLast) {
  SceneBuilder builder = builder_with_square();
  builder.add_face(Ids{0, 1, 2}, 1);
  builder.add_face(Ids{0, 1, 2, 3}, 2);
  builder.add_hole(Ids{2, 1, 0});
  builder.add_hole(Ids{3, 2, 1});
  const Scene scene = builder.take();
  ASSERT_EQ(scene.loops_of(scene.faces[0]).size(), 1U);
  const auto loops = scene.loops_of(scene.faces[1]);
  ASSERT_EQ(loops.size(), 3U);
  const auto hole = scene.corners_of(loops[2]);
  EXPECT_EQ(Ids(hole.begin(), hole.end()), (Ids{3, 2, 1}));
  EXPECT_EQ(tests::broken_invariant(scene), "");
}

TEST(SceneBuilder, KeepsLoopsThatAreTooShort) {
  SceneBuilder builder = builder_with_square();
  builder.add_face(Ids{}, 1);
  builder.add_face(Ids{2}, 2);
  builder.add_face(Ids{2, 2}, 3);
  builder.add_hole(Ids{});
  const Scene scene = builder.take();
  EXPECT_EQ(scene.faces.size(), 3U);
  EXPECT_EQ(scene.corners, (Ids{2, 2, 2}));
  EXPECT_EQ(tests::broken_invariant(scene), "");
}

TEST(SceneBuilder, KeepsVertexRecordsInStep) {
  SceneBuilder builder("a.obj", "obj");
  EXPECT_EQ(builder.add_vertex({1, 2, 3}, 10), 0U);
  EXPECT_EQ(builder.add_vertex({1, 2, 3}, 12), 1U) << "equal positions stay apart";
  EXPECT_EQ(builder.vertex_count(), 2U);
  const Scene scene = builder.take();
  EXPECT_EQ(scene.vertex_records, (std::vector<std::uint64_t>{10, 12}));
  EXPECT_EQ(tests::broken_invariant(scene), "");
}

}  // namespace
}  // namespace rad::scene
