// The files of the acceptance corpus, found through RAD_SHARED.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <sstream>

#include "tests/readers/gltf_document.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class GltfCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("RAD_SHARED");
    if (shared == nullptr) GTEST_SKIP() << "RAD_SHARED names no folder";
    corpus_ = std::filesystem::path(shared) / "corpus";
  }

  [[nodiscard]] readers::ReadResult read(const std::string& name) const {
    const auto path = corpus_ / name;
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream.is_open()) << name;
    std::stringstream bytes;
    bytes << stream.rdbuf();
    const std::string text = bytes.str();
    auto result = readers::gltf_reader.read({name, path.parent_path(), text, {}});
    EXPECT_EQ(broken_invariant(result.scene), "") << name;
    return result;
  }

  // Triangle count, signed volume and area of a file that must read without an issue.
  void expect_solid(const std::string& name, std::size_t faces, double volume, double area) const {
    const auto result = read(name);
    EXPECT_THAT(result.issues.all(), IsEmpty()) << name;
    EXPECT_EQ(result.scene.faces.size(), faces) << name;
    double volume_sum = 0;
    double area_sum = 0;
    for (std::size_t face = 0; face < result.scene.faces.size(); ++face) {
      const auto corners = corners_of(result.scene, face);
      volume_sum += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6;
      area_sum += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
    }
    EXPECT_NEAR(volume_sum, volume, 1e-6 * std::abs(volume)) << name;
    EXPECT_NEAR(area_sum, area, 1e-6 * area) << name;
  }

 private:
  std::filesystem::path corpus_;
};

TEST_F(GltfCorpus, ReadsDraco) {
  expect_solid("formats/Box_Draco.glb", 12, 1, 6);
  expect_solid("formats/BoxMetaDraco/BoxMetaDraco.gltf", 12, 1, 6);
  EXPECT_EQ(read("formats/DracoSparseMesh.gltf").scene.faces.size(), 102U);
}

// The accessor states extremes of ±32767 along y, normalised, and the node scales by 0.9303….
TEST_F(GltfCorpus, ReadsQuantisedDraco) {
  const auto result = read("formats/DenseSphere.glb");
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_EQ(result.scene.faces.size(), 30720U);
  EXPECT_EQ(result.scene.vertices.size(), 15362U);
  constexpr double kRadius = 0.9303051233291626;
  double highest = 0;
  for (const auto& vertex : result.scene.vertices) {
    highest = std::max(highest, vertex.y);
    ASSERT_NEAR(glm::length(vertex), kRadius, 0.02 * kRadius);
  }
  EXPECT_NEAR(highest, kRadius, 1e-12);
}

TEST_F(GltfCorpus, ReadsMirroredInstances) { expect_solid("formats/CubeScaledInstances/cube_att.gltf", 48, 100, 180); }

// Volumes and areas come from an independent reader.
TEST_F(GltfCorpus, ReadsBuildings) {
  expect_solid("arch/building-garage.glb", 196, 0.286660728, 5.75180645);
  expect_solid("arch/building-small-a.glb", 452, 0.49711634, 7.64652425);
  expect_solid("arch/building-small-b.glb", 600, 0.674199078, 9.01326847);
  expect_solid("arch/building-small-c.glb", 834, 0.855099702, 10.4366828);
  expect_solid("arch/no_indices_3storybuilding.glb", 72, 15580.4524, 12527.6832);
  expect_solid("arch/pavement-fountain.glb", 152, 0.106181906, 3.60700089);
  expect_solid("broken/boolean.glb", 3936, 45.923615, 197.251509);
  expect_solid("broken/boxNotManifold.glb", 12, 0.000991666713, 0.0595000019);
  expect_solid("cad/TestScene.gltf", 1096, -15.9425775, 144.764117);
}

TEST_F(GltfCorpus, RefusesMeshopt) {
  const auto result = read("formats/BoxMeshopt.glb");
  EXPECT_THAT(result.scene.faces, IsEmpty());
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError), ElementsAre(HasSubstr("EXT_meshopt_compression")));
}

TEST_F(GltfCorpus, ReadsWhatMalformedFilesStillHold) {
  expect_solid("malformed/BoxBadNormals.glb", 12, 1, 6);
  const auto infinite = read("malformed/BoxWithInfinites.glb");
  EXPECT_EQ(infinite.scene.faces.size(), 12U);
  EXPECT_THAT(infinite.issues.all(), IsEmpty());
  for (const auto& vertex : infinite.scene.vertices) {
    EXPECT_TRUE(std::isinf(vertex.x) || std::isinf(vertex.y) || std::isinf(vertex.z));
  }
  const auto index = read("malformed/IndexOutOfRange.gltf");
  EXPECT_EQ(index.scene.faces.size(), 11U);
  EXPECT_TRUE(index.issues.any(ReadIssueKind::IndexOutOfRange));
}

TEST_F(GltfCorpus, ReportsMalformedFiles) {
  EXPECT_THAT(issues_of(read("malformed/RecursiveNodes.gltf"), ReadIssueKind::ParseError),
              ElementsAre(HasSubstr("cycle @/nodes/0")));
  EXPECT_THAT(issues_of(read("malformed/NoScene.gltf"), ReadIssueKind::ParseError),
              ElementsAre(HasSubstr("/scenes/0")));
  EXPECT_THAT(issues_of(read("malformed/badArray.gltf"), ReadIssueKind::ParseError),
              ElementsAre("\"primitives\" is not an array @/meshes/0/primitives"));
  EXPECT_THAT(issues_of(read("malformed/MissingBin/BoxTextured.gltf"), ReadIssueKind::MissingResource),
              ElementsAre(HasSubstr("BoxTextured0.bin")));
}

}  // namespace
}  // namespace rad::tests
