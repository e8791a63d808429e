// Texture coordinates, normals, images, groups and smoothing groups, written and read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/corner_values_text.h"
#include "tests/support/red_pixel.h"
#include "tests/support/scene_invariants.h"
#include "tests/writers/written_files.h"

namespace rad::writers {
namespace {

using namespace tests;
using scene::dvec2;
using scene::dvec3;
using scene::Scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::shared_ptr<const scene::Image> image_at(const std::string& path) {
  return std::make_shared<scene::Image>(scene::Image{path, {}, {}, {}});
}

/// Two triangles that share an edge; the texture has a seam there, the normals have none. A third has neither.
Scene seamed() {
  scene::SceneBuilder builder("seamed.obj", "obj");
  builder.add_section({"seamed.obj", {}, scene::RecordKind::Line});
  for (const dvec3& p : {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(1, 1, 0.5), dvec3(0, 0, 3)}) {
    builder.add_vertex(p);
  }
  for (const dvec2& t : {dvec2(0, 0), dvec2(0.25, 0), dvec2(0, 0.75), dvec2(5, 6), dvec2(7, 8)}) {
    builder.add_texture_coordinates(t);
  }
  for (const dvec3& n : {dvec3(0, 0, 1), dvec3(0.6, 0, 0.8), dvec3(0, 0.6, 0.8)}) builder.add_normal(n);
  const scene::MaterialId oak = builder.material("oak");
  builder.material_at(oak).reflectance = {0.2, 0.4, 0.6};
  builder.material_at(oak).reflectance_stated = true;
  builder.material_at(oak).texture = scene::Texture{image_at("my images/oak.png"), {0.2, 0.4, 0.6}, {}, std::nullopt};
  builder.use_material(oak);
  builder.use_object(builder.object("table"));
  builder.use_group(builder.group("top"));
  builder.use_smoothing_group(2);
  builder.add_face(std::array<scene::VertexId, 3>{0, 1, 2}, 1);
  builder.set_texture_coordinates(std::array<scene::RowId, 3>{0, 1, 2});
  builder.set_normals(std::array<scene::RowId, 3>{0, 1, 2});
  builder.add_face(std::array<scene::VertexId, 3>{1, 3, 2}, 2);
  builder.set_texture_coordinates(std::array<scene::RowId, 3>{1, 3, 4});
  builder.set_normals(std::array<scene::RowId, 3>{1, 0, 2});
  builder.use_smoothing_group(0);
  builder.use_material(builder.material("paint"));
  builder.add_face(std::array<scene::VertexId, 3>{0, 4, 1}, 3);
  return builder.take();
}

Scene rewritten_as(const Scene& scene, const std::string& name) {
  const auto path = fresh_folder("attributes_" + name) / ("model." + name);
  EXPECT_EQ(write({scene}, path), "");
  const readers::ReadResult read = readers::read_file(path);
  EXPECT_THAT(read.issues.all(), IsEmpty());
  EXPECT_EQ(broken_invariant(read.scene), "");
  return read.scene;
}

nlohmann::json document_of(const Scene& scene) {
  const auto path = fresh_folder("attributes_document") / "model.gltf";
  EXPECT_EQ(write({scene}, path), "");
  return nlohmann::json::parse(bytes_of(path));
}

TEST(AttributesWritten, ToObjComeBackExactly) {
  const Scene scene = seamed();
  const Scene read = rewritten_as(scene, "obj");
  for (scene::FaceId face = 0; face < 3; ++face) {
    EXPECT_EQ(texture_of(read, face), texture_of(scene, face));
    EXPECT_EQ(normals_of(read, face), normals_of(scene, face));
  }
  EXPECT_EQ(read.smoothing_groups, scene.smoothing_groups);
  const auto& texture = read.materials.at(1).texture;
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->image->path, "my images/oak.png");
  EXPECT_EQ(texture->factor, scene.materials[1].texture->factor);
  EXPECT_EQ(read.groups, scene.groups);
  EXPECT_EQ(read.objects, scene.objects);
}

TEST(AttributesWritten, ToPlyComeBackExactlyAndZeroWhereThereWereNone) {
  const Scene scene = seamed();
  const Scene read = rewritten_as(scene, "ply");
  for (scene::FaceId face = 0; face < 2; ++face) {
    EXPECT_EQ(texture_of(read, face), texture_of(scene, face));
    EXPECT_EQ(normals_of(read, face), normals_of(scene, face));
    EXPECT_EQ(facets_of(read, false), facets_of(scene, false));
  }
  EXPECT_THAT(texture_of(read, 2), ElementsAre(dvec2(0), dvec2(0), dvec2(0)));
  EXPECT_EQ(read.vertices.size(), 8u) << "one end of the seam is split, and two corners of the plain face";
}

TEST(AttributesWritten, ToGlbComeBackAsFloatsTheOtherWayUp) {
  const Scene scene = seamed();
  const Scene read = rewritten_as(scene, "glb");
  ASSERT_EQ(read.faces.size(), 3u);
  EXPECT_THAT(texture_of(read, 0), ElementsAre(dvec2(0, 1), dvec2(0.25, 1), dvec2(0, 0.25)));
  EXPECT_THAT(texture_of(read, 1), ElementsAre(dvec2(0.25, 1), dvec2(5, -5), dvec2(7, -7)));
  EXPECT_THAT(normals_of(read, 1), ElementsAre(dvec3(0.6f, 0, 0.8f), dvec3(0, 0, 1), dvec3(0, 0.6f, 0.8f)));
  EXPECT_THAT(texture_of(read, 2), IsEmpty());
  EXPECT_THAT(normals_of(read, 2), IsEmpty());
  std::set<std::array<double, 3>> places;
  for (const dvec3& p : read.vertices) places.insert({p.x, p.y, p.z});
  EXPECT_EQ(places.size(), 5u) << "vertices of a seam have the same place to the bit";
  const Scene back = rewritten_as(read, "obj");
  EXPECT_EQ(texture_of(back, 0), texture_of(scene, 0)) << "the right way up again";
}

TEST(AttributesWritten, ToGlbTwiceAreTheSameBytes) {
  const auto folder = fresh_folder("attributes_twice");
  ASSERT_EQ(write({seamed()}, folder / "once.glb"), "");
  const Scene read = readers::read_file(folder / "once.glb").scene;
  ASSERT_EQ(write({read}, folder / "twice.glb"), "");
  EXPECT_TRUE(bytes_of(folder / "twice.glb") == bytes_of(folder / "once.glb"));
}

TEST(AttributesWritten, NameTheImageInGltf) {
  const nlohmann::json document = document_of(seamed());
  EXPECT_EQ(document["images"], nlohmann::json::parse(R"([{"uri": "my%20images/oak.png"}])"));
  EXPECT_EQ(document["textures"], nlohmann::json::parse(R"([{"source": 0, "sampler": 0}])"));
  EXPECT_EQ(document["samplers"], nlohmann::json::parse(R"([{"wrapS": 10497, "wrapT": 10497}])"));
  const nlohmann::json& oak = document["materials"][0];
  EXPECT_EQ(oak["pbrMetallicRoughness"]["baseColorTexture"], nlohmann::json::parse(R"({"index": 0})"));
  EXPECT_EQ(oak["pbrMetallicRoughness"]["baseColorFactor"], nlohmann::json({0.2, 0.4, 0.6, 1.0}));
  EXPECT_EQ(oak["extras"]["radfix"]["reflectance"], nlohmann::json({0.2, 0.4, 0.6}));
  EXPECT_FALSE(document["materials"][1]["pbrMetallicRoughness"].contains("baseColorTexture")) << "paint has no image";
}

TEST(AttributesWritten, KeepTransformSamplingAndFormatOfAnImage) {
  Scene scene = seamed();
  scene::Texture& texture = *scene.materials[1].texture;
  texture.image = image_at("C:\\pictures\\oak 1.webp");
  texture.sampling = {33071, 33648, 9728, 9987};
  texture.transform = scene::TextureTransform{{0.5, 0.25}, 1.5, {2, 4}};
  const Scene read = rewritten_as(scene, "glb");
  const auto& kept = read.materials.at(1).texture;
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->image->path, "C:/pictures/oak 1.webp");
  EXPECT_EQ(kept->sampling, texture.sampling);
  EXPECT_EQ(kept->transform, texture.transform);
  const nlohmann::json document = document_of(scene);
  EXPECT_EQ(document["extensionsUsed"], nlohmann::json({"EXT_texture_webp", "KHR_texture_transform"}));
  texture.transform->rotation = 0;
  const Scene as_obj = rewritten_as(scene, "obj");
  EXPECT_EQ(as_obj.materials.at(1).texture->transform, texture.transform) << "MTL has scale and offset";
}

TEST(AttributesWritten, PassTheBytesOfAnImageOn) {
  Scene scene = seamed();
  scene.materials[1].texture->image =
      std::make_shared<scene::Image>(scene::Image{"", "oak", "image/png", std::string(tests::kRedPixel)});
  for (const char* format : {"glb", "gltf"}) {
    const Scene read = rewritten_as(scene, format);
    ASSERT_TRUE(read.materials.at(1).texture);
    EXPECT_EQ(*read.materials[1].texture->image, *scene.materials[1].texture->image);
  }
}

TEST(AttributesWritten, LeaveAnImageOutThatNoFaceHasCoordinatesFor) {
  Scene scene = seamed();
  scene.attributes = {};
  const nlohmann::json document = document_of(scene);
  EXPECT_FALSE(document.contains("images"));
  EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], nlohmann::json({0.2, 0.4, 0.6, 1.0}));
}

TEST(AttributesWritten, GiveFacesUnderAnImageTheCoordinatesThatAViewerWouldTake) {
  Scene scene = seamed();
  scene.faces[2].material = 1;
  const Scene read = rewritten_as(scene, "glb");
  for (scene::FaceId face = 0; face < 3; ++face) EXPECT_EQ(texture_of(read, face).size(), 3u);
}

TEST(AttributesWritten, LeaveNormalsWithoutDirectionOutAndScaleOthers) {
  Scene scene = seamed();
  scene.attributes.normals.table[1] = {0, 0, 0};
  EXPECT_THAT(normals_of(rewritten_as(scene, "glb"), 0), IsEmpty());
  scene.attributes.normals.table[1] = {0, 0, 5};
  EXPECT_THAT(normals_of(rewritten_as(scene, "glb"), 0),
              ElementsAre(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0.6f, 0.8f)));
}

TEST(GroupsWritten, ToGlbComeBack) {
  Scene scene = seamed();
  EXPECT_EQ(document_of(scene)["meshes"][0]["name"], "top") << "one group";
  scene.groups.emplace_back("leg");
  scene.faces[2].group = 2;
  const Scene read = rewritten_as(scene, "glb");
  std::set<std::string> names;
  for (const scene::Face& face : read.faces) names.insert(read.objects[face.object] + "/" + read.groups[face.group]);
  EXPECT_EQ(names, (std::set<std::string>{"table/leg", "table/top"}));
}

}  // namespace
}  // namespace rad::writers
