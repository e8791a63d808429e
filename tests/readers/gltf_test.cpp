#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "tests/readers/gltf_document.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Json position(std::size_t accessor) { return {{"attributes", {{"POSITION", accessor}}}}; }

std::vector<float> fan_of(std::size_t count) {
  std::vector<float> coordinates;
  for (std::size_t i = 0; i < count; ++i) {
    coordinates.insert(coordinates.end(), {static_cast<float>(i), static_cast<float>(i * i), 0.0F});
  }
  return coordinates;
}

TEST(Gltf, SniffsBothContainers) {
  const auto sniff = readers::gltf_reader.sniff;
  EXPECT_TRUE(sniff(one_triangle().glb()));
  EXPECT_TRUE(sniff(one_triangle().text()));
  EXPECT_TRUE(sniff("\xEF\xBB\xBF \n{ \"asset\" : {\"version\":\"2.0\"}}"));
  EXPECT_FALSE(sniff("{\"type\": \"CityJSON\", \"version\": \"1.0\"}"));
  EXPECT_FALSE(sniff("solid asset version"));
  EXPECT_FALSE(sniff(""));
}

TEST(Gltf, ReadsTriangleWithoutNodesOrIndices) {
  const auto result = read_gltf(one_triangle());
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_THAT(corners_of(result.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)));
  EXPECT_EQ(result.scene.format, "gltf");
  EXPECT_EQ(result.scene.metres_per_unit, 1.0);
  EXPECT_EQ(result.scene.up, scene::UpAxis::Y);
  EXPECT_TRUE(result.scene.single_precision && result.scene.triangles_only && result.scene.splits_vertices);
  ASSERT_EQ(result.scene.sections.size(), 1U);
  EXPECT_EQ(result.scene.sections[0].pointer, "/meshes/0/primitives/0");
  EXPECT_EQ(result.scene.sections[0].kind, scene::RecordKind::Element);
}

TEST(Gltf, ReadsGlb) {
  const auto result = read_gltf(one_triangle().glb());
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(result.scene.faces.size(), 1U);
  EXPECT_EQ(result.scene.format, "glb");
}

TEST(Gltf, ReadsEveryIndexType) {
  GltfDocument document;
  const auto points = document.add_positions(fan_of(4));
  for (const auto indices : {document.add_accessor(std::vector<std::uint8_t>{0, 1, 3}, 5121, "SCALAR", 3),
                             document.add_accessor(std::vector<std::uint16_t>{0, 1, 3}, 5123, "SCALAR", 3),
                             document.add_accessor(std::vector<std::uint32_t>{0, 1, 3}, 5125, "SCALAR", 3)}) {
    document.add_mesh(position(points))["indices"] = indices;
  }
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  ASSERT_EQ(result.scene.faces.size(), 3U);
  EXPECT_EQ(result.scene.vertices.size(), 12U);
  for (std::size_t face = 0; face < 3; ++face) EXPECT_EQ(corners_of(result.scene, face)[2], dvec3(3, 9, 0));
}

TEST(Gltf, ReadsStripsAndFansWithTheirTurn) {
  GltfDocument document;
  const auto points = document.add_positions(fan_of(4));
  document.add_mesh(position(points))["mode"] = 5;
  document.add_mesh(position(points))["mode"] = 6;
  const auto result = read_gltf(document);
  EXPECT_THAT(result.scene.corners, ElementsAre(0, 1, 2, 1, 3, 2, 5, 6, 4, 6, 7, 4));
  EXPECT_EQ(result.scene.faces[1].source.record, 1U);
}

TEST(Gltf, LeavesOutTrianglesWithBadIndicesAndKeepsRecords) {
  GltfDocument document;
  auto& primitive = document.add_mesh(position(document.add_positions(fan_of(3))));
  primitive["indices"] = document.add_indices({0, 1, 7, 0, 1, 2});
  const auto result = read_gltf(document);
  ASSERT_EQ(result.scene.faces.size(), 1U);
  EXPECT_EQ(result.scene.faces[0].source.record, 1U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::IndexOutOfRange),
              ElementsAre("vertex index 7 of triangle 0 exceeds the 3 vertices of the primitive "
                          "@/meshes/0/primitives/0"));
}

TEST(Gltf, ReportsCornersThatMakeNoTriangle) {
  GltfDocument document;
  document.add_mesh(position(document.add_positions(fan_of(5))));
  const auto result = read_gltf(document);
  EXPECT_EQ(result.scene.faces.size(), 1U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("the last 2 corners make no triangle @/meshes/0/primitives/0"));
}

TEST(Gltf, ReadsQuantisedPositions) {
  GltfDocument document;
  const auto plain = document.add_accessor(std::vector<std::int16_t>{0, 0, 0, 300, 0, 0, 0, -7, 0}, 5122, "VEC3", 3);
  const auto shorts =
      document.add_accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, -32768, 0}, 5122, "VEC3", 3);
  const auto bytes = document.add_accessor(std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 51, 0}, 5121, "VEC3", 3);
  for (const auto accessor : {shorts, bytes}) document.json["accessors"][accessor]["normalized"] = true;
  for (const auto accessor : {plain, shorts, bytes}) document.add_mesh(position(accessor));
  document.json["extensionsRequired"] = Json::array({"KHR_mesh_quantization"});
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  ASSERT_EQ(result.scene.faces.size(), 3U);
  EXPECT_EQ(result.scene.vertices[1], dvec3(300, 0, 0));
  EXPECT_EQ(result.scene.vertices[5], dvec3(0, -1, 0));
  EXPECT_EQ(result.scene.vertices[8], dvec3(0, 51.0 / 255.0, 0));
}

TEST(Gltf, HonoursStrideAndOffset) {
  GltfDocument document;
  const auto accessor = document.add_accessor(std::vector<float>{9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0}, 5126, "VEC3", 3);
  document.json["bufferViews"][0]["byteStride"] = 16;
  document.json["accessors"][accessor]["byteOffset"] = 4;
  document.add_mesh(position(accessor));
  EXPECT_THAT(corners_of(read_gltf(document).scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)));
}

TEST(Gltf, AppliesSparseValuesWithAndWithoutBase) {
  GltfDocument document;
  const auto based = document.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const Json sparse = {
      {"count", 2},
      {"indices", {{"bufferView", document.add_view(std::vector<std::uint8_t>{1, 2})}, {"componentType", 5121}}},
      {"values", {{"bufferView", document.add_view(std::vector<float>{5, 0, 0, 0, 6, 0})}}}};
  document.json["accessors"][based]["sparse"] = sparse;
  document.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}, {"sparse", sparse}});
  document.add_mesh(position(based));
  document.add_mesh(position(based + 1));
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  ASSERT_EQ(result.scene.faces.size(), 2U);
  for (const std::size_t face : {0U, 1U}) {
    EXPECT_THAT(corners_of(result.scene, face), ElementsAre(dvec3(0, 0, 0), dvec3(5, 0, 0), dvec3(0, 6, 0)));
  }
}

TEST(Gltf, KeepsCoordinatesThatAreNotFinite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  GltfDocument document;
  document.add_mesh(position(document.add_positions({kInfinity, 2, 0, 1, 0, 0, 0, std::nanf(""), 0})));
  document.json["nodes"] = Json::parse(R"([{"mesh": 0, "translation": [0, 0, 5]}])");
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  ASSERT_EQ(result.scene.faces.size(), 1U);
  EXPECT_EQ(result.scene.vertices[0], dvec3(kInfinity, 2, 0));
  EXPECT_EQ(result.scene.vertices[1], dvec3(1, 0, 5));
  EXPECT_TRUE(std::isnan(result.scene.vertices[2].y));
}

TEST(Gltf, CountsWhatIsNoSurface) {
  GltfDocument document = one_triangle();
  for (const int mode : {0, 1, 2, 3}) document.add_mesh(position(0))["mode"] = mode;
  document.json["meshes"][0]["primitives"][0]["targets"] = Json::parse(R"([{"POSITION": 0}])");
  document.json["skins"] = Json::parse(R"([{"joints": [0]}, {"joints": [0]}])");
  document.json["animations"] = Json::array({Json::object()});
  document.json["cameras"] = Json::array({Json::object()});
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({Json::object(), Json::object()});
  const auto result = read_gltf(document);
  EXPECT_EQ(result.scene.faces.size(), 1U);
  std::map<std::string, std::uint64_t> counts;
  for (const auto& issue : result.issues.all()) {
    EXPECT_EQ(issue.kind, ReadIssueKind::UnsupportedContent);
    counts[issue.what] = issue.count;
  }
  const std::map<std::string, std::uint64_t> expected = {
      {"skins", 2},         {"animations", 1},       {"cameras", 1},        {"punctual lights", 2},
      {"morph targets", 1}, {"point primitives", 1}, {"line primitives", 3}};
  EXPECT_EQ(counts, expected);
}

TEST(Gltf, ReadsMaterials) {
  GltfDocument document = one_triangle();
  document.json["materials"] = Json::parse(R"([
    {"name": "wall", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 1], "metallicFactor": 0.25},
     "doubleSided": true},
    {"name": "wall", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 1]}},
    {"emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 40}}},
    {"name": "sign", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1]},
     "extensions": {"KHR_materials_unlit": {}}},
    {"name": "wood", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}])");
  document.json["meshes"][0]["primitives"][0]["material"] = 1;
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  const auto& materials = result.scene.materials;
  ASSERT_EQ(materials.size(), 6U);
  EXPECT_FALSE(materials[0].reflectance_stated);
  EXPECT_EQ(materials[1].reflectance, dvec3(0.8, 0.4, 0.2) * 0.75);
  EXPECT_TRUE(materials[1].double_sided && materials[1].reflectance_stated);
  EXPECT_EQ(materials[2].name, "wall (2)");
  EXPECT_EQ(materials[2].reflectance, dvec3(0));
  EXPECT_EQ(materials[3].name, "material 2");
  EXPECT_EQ(materials[3].emission, dvec3(40, 20, 0));
  EXPECT_EQ(materials[3].emission_unit, scene::Material::EmissionUnit::Luminance);
  EXPECT_FALSE(materials[3].reflectance_stated);
  EXPECT_EQ(materials[4].reflectance, dvec3(0.5));
  EXPECT_FALSE(materials[5].reflectance_stated);
  EXPECT_EQ(result.scene.faces[0].material, 2U);
}

TEST(Gltf, FallsBackOnTheUnnamedMaterial) {
  GltfDocument document = one_triangle();
  document.json["meshes"][0]["primitives"][0]["material"] = 3;
  const auto result = read_gltf(document);
  EXPECT_EQ(result.scene.faces[0].material, 0U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("material 3 does not exist @/meshes/0/primitives/0"));
}

}  // namespace
}  // namespace rad::tests
