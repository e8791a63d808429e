// Texture coordinates, normals and textures of glTF.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/readers/gltf_document.h"
#include "tests/support/corner_values_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using scene::dvec2;
using scene::dvec3;
using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// One triangle with two sets of texture coordinates, normals along z, and a material whose image is on set `set`.
GltfDocument textured(std::uint64_t set) {
  GltfDocument document = one_triangle();
  Json& attributes = document.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["TEXCOORD_0"] = document.add_accessor(std::vector<float>{0, 0, 1, 0, 0.5f, 0.1f}, 5126, "VEC2", 3);
  attributes["TEXCOORD_1"] =
      document.add_accessor(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, 5123, "VEC2", 3);
  document.json["accessors"].back()["normalized"] = true;
  attributes["NORMAL"] = document.add_accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
  document.json["meshes"][0]["primitives"][0]["material"] = 0;
  document.json["images"] = Json::parse(R"([{"uri": "my%20images/oak.png"}])");
  document.json["samplers"] = Json::parse(R"([{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}])");
  document.json["textures"] = Json::parse(R"([{"source": 0, "sampler": 0}])");
  document.json["materials"] = Json::parse(
      R"([{"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.4, 0.6, 1], "metallicFactor": 0, "baseColorTexture":
          {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.5, 0], "scale": [2, 3], "rotation": 1}}}}}])");
  document.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = set;
  return document;
}

TEST(GltfAttributes, AreThoseOfTheVertices) {
  const auto result = read_gltf(textured(0));
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(broken_invariant(result.scene), "");
  EXPECT_THAT(texture_of(result.scene, 0), ElementsAre(dvec2(0, 0), dvec2(1, 0), dvec2(0.5, 0.1f)));
  EXPECT_THAT(normals_of(result.scene, 0), ElementsAre(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1)));
  EXPECT_EQ(result.scene.attributes.texture_origin, scene::TextureOrigin::UpperLeft);
}

TEST(GltfAttributes, AreOfTheSetThatTheImageIsOn) {
  const auto result = read_gltf(textured(1));
  EXPECT_THAT(texture_of(result.scene, 0), ElementsAre(dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)));
}

TEST(GltfAttributes, ThatDoNotFitTheVerticesAreLeftOut) {
  GltfDocument document = textured(0);
  document.json["accessors"][1]["count"] = 2;
  const auto result = read_gltf(document);
  EXPECT_THAT(texture_of(result.scene, 0), IsEmpty());
  EXPECT_EQ(normals_of(result.scene, 0).size(), 3u);
  EXPECT_THAT(issues_of(result, ReadIssueKind::UnsupportedContent), ElementsAre(HasSubstr("another number")));
}

TEST(GltfAttributes, NormalsTurnWithTheirMeshAndTexturesStay) {
  GltfDocument document = textured(0);
  // A quarter turn about x, then three times as high; and a mirror image.
  document.json["nodes"] = Json::parse(
      R"([{"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]},
          {"mesh": 0, "matrix": [1,0,0,0, 0,0,3,0, 0,-1,0,0, 5,6,7,1]}])");
  const auto result = read_gltf(document);
  EXPECT_EQ(broken_invariant(result.scene), "");
  ASSERT_EQ(result.scene.faces.size(), 3u);
  EXPECT_EQ(normals_of(result.scene, 0)[0], dvec3(0, 0, 1));
  EXPECT_EQ(normals_of(result.scene, 1)[0], dvec3(0, 0, 1));
  EXPECT_NEAR(glm::distance(normals_of(result.scene, 2)[0], dvec3(0, -1, 0)), 0, 1e-15);
  EXPECT_THAT(texture_of(result.scene, 1), ElementsAre(dvec2(0, 0), dvec2(0.5, 0.1f), dvec2(1, 0)))
      << "the mirror image is run through the other way";
  EXPECT_EQ(result.scene.attributes.texture_coordinates.table.size(), 3u) << "instances share them";
}

TEST(GltfTextures, KeepNameSamplingAndTransform) {
  const auto result = read_gltf(textured(0));
  const auto& texture = result.scene.materials.at(1).texture;
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->image->path, "my images/oak.png");
  EXPECT_FALSE(texture->image->embedded());
  EXPECT_EQ(texture->factor, (std::array{0.2, 0.4, 0.6}));
  EXPECT_EQ(texture->sampling, (scene::Sampling{33071, 33648, 9728, 0}));
  EXPECT_EQ(texture->transform, (scene::TextureTransform{{0.5, 0}, 1, {2, 3}}));
  EXPECT_EQ(result.scene.materials[1].reflectance, dvec3(0.1, 0.2, 0.3)) << "an unknown image counts as 0.5";
}

TEST(GltfTextures, KeepEmbeddedBytesOnce) {
  GltfDocument document = textured(0);
  const std::size_t view = document.add_view(std::vector<char>{'P', 'N', 'G', '!', '?'});
  document.json["images"] = Json::parse(R"([{"mimeType": "image/png", "name": "oak"}])");
  document.json["images"][0]["bufferView"] = view;
  document.json["materials"].push_back(document.json["materials"][0]);
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  const auto& first = result.scene.materials.at(1).texture;
  const auto& second = result.scene.materials.at(2).texture;
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->image, second->image) << "one copy of the bytes";
  EXPECT_EQ(*first->image, (scene::Image{"", "oak", "image/png", "PNG!?"}));
}

TEST(GltfTextures, KeepTheBytesOfADataUri) {
  GltfDocument document = textured(0);
  document.json["images"][0]["uri"] = "data:image/jpeg;base64," + base64("JPEG");
  const auto result = read_gltf(document);
  ASSERT_TRUE(result.scene.materials.at(1).texture);
  EXPECT_EQ(*result.scene.materials[1].texture->image, (scene::Image{"", "", "image/jpeg", "JPEG"}));
}

TEST(GltfTextures, CannotTakeMoreBytesThanTheFileHas) {
  GltfDocument document = textured(0);
  const std::size_t view = document.add_view(std::vector<char>(4000, 'x'));
  document.json["images"] = Json::array();
  document.json["textures"] = Json::array();
  document.json["materials"] = Json::array();
  for (int i = 0; i < 20; ++i) {
    document.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    document.json["textures"].push_back({{"source", i}});
    document.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
  }
  const auto result = read_gltf(document);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), testing::Contains(HasSubstr("more bytes than the file")));
}

TEST(GltfTextures, ThatLeadNowhereAreNone) {
  for (const char* pointer : {"/textures/0/source", "/materials/0/pbrMetallicRoughness/baseColorTexture/index"}) {
    GltfDocument document = textured(0);
    document.json[Json::json_pointer(pointer)] = 7;
    const auto result = read_gltf(document);
    EXPECT_FALSE(result.scene.materials.at(1).texture);
    EXPECT_THAT(result.issues.all(), IsEmpty());
  }
}

}  // namespace
}  // namespace rad::tests
