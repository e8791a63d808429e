#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/readers/gltf_document.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t kPositionId = 7;

// One triangle whose position attribute stores `Stored`, without quantisation.
template <typename Stored>
std::vector<char> draco_triangle(draco::DataType type, const std::array<std::array<Stored, 3>, 3>& corners) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, type);
  builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(0), corners[0].data(), corners[1].data(),
                                    corners[2].data());
  const auto mesh = builder.Finalize();
  mesh->attribute(attribute)->set_unique_id(kPositionId);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

GltfDocument compressed(const std::vector<char>& stream, int component_type, bool normalized) {
  GltfDocument document;
  const auto view = document.add_view(stream);
  document.json["accessors"] =
      Json::array({{{"componentType", component_type}, {"type", "VEC3"}, {"count", 3}, {"normalized", normalized}}});
  auto& primitive = document.add_mesh({{"attributes", {{"POSITION", 0}}}});
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                           {"attributes", {{"POSITION", kPositionId}}}};
  document.json["extensionsRequired"] = Json::array({"KHR_draco_mesh_compression"});
  return document;
}

std::vector<char> float_stream() {
  return draco_triangle<float>(draco::DT_FLOAT32, {{{0, 0, 0}, {0.1F, 0, 0}, {0, 3, 0}}});
}

std::vector<char> short_stream() {
  return draco_triangle<std::int16_t>(draco::DT_INT16, {{{0, 0, 0}, {32767, 0, 0}, {0, -32767, 0}}});
}

TEST(GltfDraco, ReadsFloatsExactly) {
  const auto result = read_gltf(compressed(float_stream(), 5126, false));
  EXPECT_THAT(result.issues.all(), IsEmpty());
  ASSERT_EQ(result.scene.faces.size(), 1U);
  EXPECT_THAT(corners_of(result.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(0.1F, 0, 0), dvec3(0, 3, 0)));
}

TEST(GltfDraco, HonoursTheComponentTypeOfTheAccessor) {
  const auto plain = read_gltf(compressed(short_stream(), 5122, false));
  ASSERT_EQ(plain.scene.faces.size(), 1U);
  EXPECT_THAT(corners_of(plain.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(32767, 0, 0), dvec3(0, -32767, 0)));
  const auto normalized = read_gltf(compressed(short_stream(), 5122, true));
  ASSERT_EQ(normalized.scene.faces.size(), 1U);
  EXPECT_THAT(corners_of(normalized.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, -1, 0)));
}

TEST(GltfDraco, FindsTheAttributeByUniqueIdOnly) {
  GltfDocument document = compressed(float_stream(), 5126, false);
  document.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 0;
  EXPECT_THAT(issues_of(read_gltf(document), ReadIssueKind::ParseError), ElementsAre(HasSubstr("with id 0")));
}

TEST(GltfDraco, SurvivesEveryCutAndEveryFlippedByte) {
  const std::vector<char> whole = float_stream();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(broken_invariant(read_gltf(compressed(cut, 5126, false)).scene), "");
    std::vector<char> flipped = whole;
    flipped[size] = static_cast<char>(~flipped[size]);
    EXPECT_EQ(broken_invariant(read_gltf(compressed(flipped, 5126, false)).scene), "");
  }
}

}  // namespace
}  // namespace rad::tests
