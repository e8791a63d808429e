#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <sstream>

#include "tests/readers/gltf_document.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

double signed_volume(const scene::Scene& scene) {
  double sum = 0;
  for (std::size_t face = 0; face < scene.faces.size(); ++face) {
    const auto corners = corners_of(scene, face);
    sum += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6;
  }
  return sum;
}

readers::ReadResult read_fixture(const std::string& name) {
  const auto path = std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/gltf" / name;
  std::ifstream stream(path, std::ios::binary);
  std::stringstream bytes;
  bytes << stream.rdbuf();
  return readers::gltf_reader.read({name, path.parent_path(), bytes.str(), {}});
}

TEST(GltfNodes, PlacesInstancesAndTurnsMirroredOnes) {
  const auto result = read_fixture("mirrored_instances.gltf");
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(result.scene.faces.size(), 12U);
  EXPECT_EQ(result.scene.vertices.size(), 12U);
  EXPECT_NEAR(signed_volume(result.scene), (2.0 + 1.0 + 1.0) / 6.0, 1e-12);
  EXPECT_EQ(result.scene.vertices[1], dvec3(-2, 0, 0));
  EXPECT_NEAR(glm::distance(result.scene.vertices[5], dvec3(0.28, 0, 5 - 0.96)), 0, 1e-12);
  EXPECT_EQ(result.scene.vertices[11], dvec3(10, 0, -1));
  EXPECT_THAT(result.scene.objects, ElementsAre("", "left", "turned", "tetrahedron"));
  EXPECT_THAT(result.scene.groups, ElementsAre("", "tetrahedron"));
  EXPECT_EQ(result.scene.sections.size(), 3U);
}

TEST(GltfNodes, ReadsCompanionBufferWithEscapedName) {
  const auto result = read_fixture("companion_buffer.gltf");
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(result.scene.faces.size(), 4U);
}

TEST(GltfNodes, ReadsTheRestBesideAMissingBuffer) {
  const auto result = read_fixture("missing_buffer.gltf");
  EXPECT_THAT(issues_of(result, ReadIssueKind::MissingResource),
              ElementsAre(HasSubstr("buffer file \"absent.bin\" cannot be opened")));
  EXPECT_EQ(result.issues.all().size(), 1U);
  EXPECT_EQ(result.scene.faces.size(), 4U);
}

TEST(GltfNodes, ReportsCycleOnce) {
  const auto result = read_fixture("node_cycle.gltf");
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("the node is its own ancestor: nodes form a cycle @/nodes/0"));
  EXPECT_EQ(result.scene.faces.size(), 4U);
}

TEST(GltfNodes, ReportsCycleThatNoRootLeadsTo) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"children": [2]}, {"children": [1]}])");
  const auto result = read_gltf(document);
  EXPECT_EQ(result.scene.faces.size(), 1U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("the node is part of a cycle of nodes, which is left out @/nodes/1"));
}

TEST(GltfNodes, RefusesUnknownRequiredExtension) {
  const auto result = read_fixture("unknown_required_extension.gltf");
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), ElementsAre(HasSubstr("VENDOR_unheard_of")));
  EXPECT_THAT(result.scene.faces, IsEmpty());
}

TEST(GltfNodes, ReadsOnlyTheDefaultScene) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::parse(R"([{"mesh": 0, "name": "shown"}, {"mesh": 0, "name": "hidden"}])");
  EXPECT_EQ(read_gltf(document).scene.faces.size(), 2U);
  document.json["scenes"] = Json::parse(R"([{"nodes": [1]}, {"nodes": [0]}])");
  document.json["scene"] = 1;
  EXPECT_THAT(read_gltf(document).scene.objects, ElementsAre("", "shown"));
  document.json["scene"] = 2;
  const auto result = read_gltf(document);
  EXPECT_EQ(result.scene.faces.size(), 2U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), ElementsAre(HasSubstr("@/scenes/2")));
}

TEST(GltfNodes, NamesRepeatedObjectsApart) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::parse(R"json([{"mesh": 0, "name": "chair"}, {"mesh": 0, "name": "chair"},
                                               {"mesh": 0}, {"mesh": 0, "name": "chair (2)"}])json");
  EXPECT_THAT(read_gltf(document).scene.objects, ElementsAre("", "chair", "chair (2)", "node 2", "chair (2) (2)"));
}

TEST(GltfNodes, PlacesSharedNodeOnceForEachParent) {
  GltfDocument document = one_triangle();
  document.json["nodes"] =
      Json::parse(R"([{"children": [2]}, {"children": [2], "translation": [1, 0, 0]}, {"mesh": 0, "name": "leaf"}])");
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(result.scene.vertices[3], dvec3(1, 0, 0));
  EXPECT_THAT(result.scene.objects, ElementsAre("", "leaf", "leaf (2)"));
}

TEST(GltfNodes, CapsDepth) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::array();
  for (int i = 0; i < 300; ++i) document.json["nodes"].push_back({{"children", Json::array({i + 1})}});
  document.json["nodes"].push_back({{"mesh", 0}});
  const auto result = read_gltf(document);
  EXPECT_THAT(result.scene.faces, IsEmpty());
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("nodes are nested deeper than 256 @/nodes/256"));
}

TEST(GltfNodes, CapsInstancesAndWalksOverSharedNodes) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::array();
  for (int i = 0; i < 60; ++i) document.json["nodes"].push_back({{"children", Json::array({i + 1, i + 1})}});
  document.json["nodes"].push_back({{"mesh", 0}});
  readers::Limits limits;
  limits.instances = 1000;
  const auto result = read_gltf(document.text(), limits);
  EXPECT_LE(result.scene.faces.size(), 1000U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), ElementsAre(HasSubstr("passes the limit of instances")));
}

TEST(GltfNodes, PlacesGpuInstances) {
  GltfDocument document = one_triangle();
  const auto translations = document.add_positions({0, 0, 0, 5, 0, 0});
  const auto scales = document.add_positions({1, 1, 1, 1, 1, -2});
  document.json["nodes"] = Json::array({{{"mesh", 0}, {"name", "tree"}}});
  document.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translations},
                                                                                      {"SCALE", scales}};
  document.json["extensionsRequired"] = Json::array({"EXT_mesh_gpu_instancing"});
  const auto result = read_gltf(document);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_THAT(result.scene.objects, ElementsAre("", "tree copy 0", "tree copy 1"));
  EXPECT_THAT(corners_of(result.scene, 1), ElementsAre(dvec3(5, 0, 0), dvec3(5, 1, 0), dvec3(6, 0, 0)));
}

TEST(GltfNodes, StopsAtTheLimitOfVertices) {
  GltfDocument document = one_triangle();
  document.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0}, {"mesh": 0}])");
  readers::Limits limits;
  limits.vertices = 6;
  const auto result = read_gltf(document.text(), limits);
  EXPECT_EQ(result.scene.faces.size(), 2U);
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), ElementsAre(HasSubstr("passes the limit")));
}

}  // namespace
}  // namespace rad::tests
