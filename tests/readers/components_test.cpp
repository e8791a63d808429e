// Readers that stand on libraries and programs which may be absent: skipped where they are.
#include "readers/components.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>

#include "readers/instance_lines.h"
#include "scene/finding.h"
#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using testing::HasSubstr;
using tests::issue_text;

const std::filesystem::path kFormats = std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats";

bool is_there(std::string_view name) {
  const auto component = std::ranges::find(components(), name, &Component::name);
  return component != components().end() && component->reader != nullptr && !component->version.empty();
}

struct Box {
  dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

Box box_of(const scene::Scene& scene) {
  Box box;
  for (const scene::VertexId corner : scene.corners) {
    box.low = glm::min(box.low, scene.vertices[corner]);
    box.high = glm::max(box.high, scene.vertices[corner]);
  }
  return box;
}

TEST(Components, AreNamedWithTheirFormats) {
  ASSERT_EQ(components().size(), 3u);
  for (const Component& component : components()) {
    EXPECT_FALSE(component.formats.empty());
    const std::string path = "a" + std::string(component.suffixes.front());
    EXPECT_EQ(missing_component(path) != nullptr, component.reader == nullptr);
    if (component.reader != nullptr) continue;
    EXPECT_THAT(issue_text(tests::read_text("x", path)), HasSubstr("which this build is without; export"));
  }
  EXPECT_EQ(missing_component("a.obj"), nullptr);
}

TEST(Assimp, ReadsColladaInItsOwnFrame) {
  if (!is_there("assimp")) GTEST_SKIP() << "built without assimp";
  const ReadResult result = read_file(kFormats / "dae/plate.dae");
  EXPECT_EQ(issue_text(result), "");
  const scene::Scene& scene = result.scene;
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_EQ(scene.format, "dae");
  ASSERT_EQ(scene.faces.size(), 2u);
  EXPECT_EQ(scene.loops[scene.faces[0].first_loop].count, 4u);
  EXPECT_EQ(scene.metres_per_unit, 0.01);
  EXPECT_EQ(scene.up, scene::UpAxis::Z);
  EXPECT_EQ(box_of(scene).high, dvec3(100, 75, 70));
  EXPECT_EQ(scene.objects[scene.faces[0].object], "table");
  const scene::Material& material = scene.materials[scene.faces[0].material];
  EXPECT_EQ(material.name, "paint");
  EXPECT_EQ(material.reflectance, dvec3(0.5, 0.25, 0.125));
}

TEST(Assimp, RefusesWhatItCannotRead) {
  if (!is_there("assimp")) GTEST_SKIP() << "built without assimp";
  EXPECT_THAT(issue_text(tests::read_text("<?xml version=\"1.0\"?><COLLADA>", "a.dae")),
              HasSubstr("assimp cannot read the file"));
  EXPECT_THAT(issue_text(tests::read_text("hello", "a.3ds")), HasSubstr("assimp cannot read the file"));
}

TEST(Ifc, CutsOpeningsAndNamesProducts) {
  if (!is_there("web-ifc")) GTEST_SKIP() << "the helper for IFC is not there";
  const ReadResult result = read_file(kFormats / "ifc/wall.ifc");
  if (issue_text(result).find("npm ci") != std::string::npos) GTEST_SKIP() << issue_text(result);
  EXPECT_EQ(issue_text(result), "");
  const scene::Scene& scene = result.scene;
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_EQ(scene.metres_per_unit, 1.0);
  // A box of 12 triangles and more: two faces with a hole, four inside of it.
  EXPECT_EQ(scene.faces.size(), 32u);
  const Box box = box_of(scene);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.low[axis], 0, 1e-6);
    EXPECT_NEAR(box.high[axis], dvec3(4, 0.2, 2.7)[axis], 1e-6);
  }
  EXPECT_EQ(scene.objects[scene.faces[0].object], "South wall");
  EXPECT_EQ(scene.groups[scene.faces[0].group], "Ground floor");
  EXPECT_EQ(scene.materials[scene.faces[0].material].name, "Brick");
  EXPECT_THAT(scene::reference_to(scene, 0).ref, HasSubstr("wall.ifc:18 (IfcWall 1YvctVUKr0kugbFTf53O9L)"));
}

TEST(InstanceLines, FindsNumbersAtTheStartOfLines) {
  const auto lines = lines_of_instances("ISO;\n#12=A();\n  #7 = B(#12);\nC(#9)\n#x=1\n");
  EXPECT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines.at(12), 2u);
  EXPECT_EQ(lines.at(7), 3u);
}

}  // namespace
}  // namespace rad::readers
