// Documents that are damaged or lie about themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/gltf_uri.h"
#include "tests/readers/gltf_document.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {
namespace {

using readers::gltf::base64_decoded;
using readers::gltf::percent_decoded;
using scene::ReadIssueKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

GltfDocument two_triangles() {
  GltfDocument document = one_triangle();
  document.json["meshes"][0]["primitives"][0]["indices"] = document.add_indices({0, 1, 2, 2, 1, 0});
  return document;
}

// The single ParseError of a document that must give no face.
std::string only_fault(const GltfDocument& document) {
  const auto result = read_gltf(document);
  EXPECT_THAT(result.scene.faces, IsEmpty());
  const auto faults = issues_of(result, ReadIssueKind::ParseError);
  EXPECT_THAT(faults, SizeIs(1));
  return faults.empty() ? "" : faults[0];
}

TEST(GltfHostile, SurvivesEveryCutOfAGlb) {
  const std::string whole = two_triangles().glb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result = read_gltf(std::string_view(whole).substr(0, size));
    EXPECT_EQ(broken_invariant(result.scene), "") << size;
    EXPECT_TRUE(result.issues.any(ReadIssueKind::ParseError)) << size;
  }
  EXPECT_THAT(read_gltf(whole).scene.faces, SizeIs(2));
}

TEST(GltfHostile, SurvivesEveryCutOfText) {
  const std::string whole = two_triangles().text();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result = read_gltf(std::string_view(whole).substr(0, size));
    EXPECT_THAT(result.scene.faces, IsEmpty());
    EXPECT_TRUE(result.issues.any(ReadIssueKind::ParseError)) << size;
  }
}

// The parser stops at the end of the word that does not belong there.
TEST(GltfHostile, NamesThePlaceOfBrokenJson) {
  const auto result = read_gltf("{\"asset\": {\"version\" \"2.0\"}}");
  ASSERT_THAT(result.issues.all(), SizeIs(1));
  EXPECT_EQ(result.issues.all()[0].what, "not well-formed JSON");
  EXPECT_EQ(result.issues.all()[0].place.byte_offset, 25U);
}

TEST(GltfHostile, ReadsDeeplyNestedJsonWithoutRecursion) {
  constexpr std::size_t kDepth = 500'000;
  std::string text = one_triangle().text();
  text.pop_back();
  text += ",\"extras\":" + std::string(kDepth, '[') + std::string(kDepth, ']') + "}";
  EXPECT_THAT(read_gltf(text).scene.faces, SizeIs(1));
}

TEST(GltfHostile, RefusesOtherVersions) {
  GltfDocument document = one_triangle();
  document.json["asset"]["version"] = "1.0";
  EXPECT_EQ(only_fault(document), "glTF version \"1.0\" is not read, only 2.0 @/asset/version");
  std::string glb = one_triangle().glb();
  glb[4] = 1;
  EXPECT_THAT(issues_of(read_gltf(glb), ReadIssueKind::ParseError), ElementsAre(HasSubstr("GLB version 1")));
}

TEST(GltfHostile, RefusesCountsWithoutBytes) {
  GltfDocument document = two_triangles();
  auto& accessors = document.json["accessors"];
  accessors[0]["count"] = 150'000'000;
  EXPECT_THAT(only_fault(document), HasSubstr("150000000 elements reach beyond its buffer view @/accessors/0"));
  accessors[0].erase("bufferView");
  EXPECT_THAT(only_fault(document), HasSubstr("more elements than the file has bytes @/accessors/0"));
  document = two_triangles();
  document.json["accessors"][1]["count"] = 18446744073709551615U;
  EXPECT_THAT(only_fault(document), HasSubstr("passes the limit of 800000000 corners"));
}

TEST(GltfHostile, RefusesViewsBeyondTheirBuffer) {
  GltfDocument document = two_triangles();
  document.json["bufferViews"][0]["byteOffset"] = 18446744073709551615U;
  EXPECT_THAT(only_fault(document), HasSubstr("reaches beyond its buffer of 48 bytes @/bufferViews/0"));
  document.json["bufferViews"][0] = {{"buffer", 4}, {"byteLength", 36}};
  EXPECT_THAT(only_fault(document), HasSubstr("@/bufferViews/0"));
  document.json["accessors"][0]["bufferView"] = 9;
  EXPECT_THAT(only_fault(document), HasSubstr("@/bufferViews/9"));
}

TEST(GltfHostile, RefusesElementsThatDoNotFit) {
  GltfDocument document = two_triangles();
  document.json["bufferViews"][0]["byteStride"] = 4;
  EXPECT_THAT(only_fault(document), HasSubstr("byteStride 4 is below the element size 12"));
  document.json["bufferViews"][0]["byteStride"] = 18446744073709551615U;
  EXPECT_THAT(only_fault(document), HasSubstr("@/accessors/0"));
  document.json["accessors"][0]["componentType"] = 5124;
  EXPECT_THAT(only_fault(document), HasSubstr("lacks a sound componentType"));
  document.json["accessors"][0] = {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}};
  EXPECT_THAT(only_fault(document), HasSubstr("not of type VEC3"));
}

TEST(GltfHostile, RefusesIndicesThatAreNoUnsignedIntegers) {
  GltfDocument document = one_triangle();
  document.json["meshes"][0]["primitives"][0]["indices"] =
      document.add_accessor(std::vector<float>{0, 1, 2}, 5126, "SCALAR", 3);
  EXPECT_THAT(only_fault(document), HasSubstr("not plain unsigned integers"));
}

TEST(GltfHostile, RefusesSparseIndexOutOfRange) {
  GltfDocument document = one_triangle();
  document.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", document.add_view(std::vector<std::uint8_t>{3})}, {"componentType", 5121}}},
      {"values", {{"bufferView", document.add_view(std::vector<float>{5, 0, 0})}}}};
  EXPECT_THAT(only_fault(document), HasSubstr("sparse index 3 exceeds the accessor's 3 elements"));
}

TEST(GltfHostile, ReportsWrongTypesWithTheirPointer) {
  GltfDocument document = one_triangle();
  document.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "0";
  EXPECT_THAT(issues_of(read_gltf(document), ReadIssueKind::ParseError),
              ElementsAre("\"POSITION\" is not a whole number from 0 @/meshes/0/primitives/0/attributes/POSITION",
                          "the primitive has no POSITION @/meshes/0/primitives/0"));
  document.json["meshes"] = {{"primitives", 3}};
  EXPECT_EQ(only_fault(document), "\"meshes\" is not an array @/meshes");
}

TEST(GltfHostile, RefusesModesThatDoNotExist) {
  GltfDocument document = one_triangle();
  document.json["meshes"][0]["primitives"][0]["mode"] = 7;
  EXPECT_THAT(only_fault(document), HasSubstr("primitive mode 7"));
}

TEST(GltfHostile, OpensNothingOutsideTheFolder) {
  for (const char* uri : {"../secret.bin", "a/../../secret.bin", "%2e%2e/secret.bin", "/etc/hostname",
                          "file:///etc/hostname", "https://example.org/room.bin", "..%5Csecret.bin", "a%00b", ""}) {
    GltfDocument document = one_triangle();
    document.json["buffers"] = Json::array({{{"byteLength", 36}, {"uri", uri}}});
    document.bytes.clear();
    const auto result = read_gltf(document);
    EXPECT_THAT(result.scene.faces, IsEmpty());
    EXPECT_THAT(issues_of(result, ReadIssueKind::MissingResource),
                ElementsAre(HasSubstr("is not a file in the model's folder")))
        << uri;
  }
  EXPECT_EQ(percent_decoded("b%20c%2E"), "b c.");
  EXPECT_EQ(percent_decoded("50%.bin"), std::nullopt);
  EXPECT_EQ(percent_decoded("%2"), std::nullopt);
}

TEST(GltfHostile, DecodesBase64Strictly) {
  EXPECT_EQ(base64_decoded("TWFu"), "Man");
  EXPECT_EQ(base64_decoded("TWE="), "Ma");
  EXPECT_EQ(base64_decoded("TQ"), "M");
  EXPECT_EQ(base64_decoded(""), "");
  EXPECT_EQ(base64_decoded("T"), std::nullopt);
  EXPECT_EQ(base64_decoded("TW u"), std::nullopt);
}

TEST(GltfHostile, ReportsBufferShorterThanStated) {
  GltfDocument document = one_triangle();
  Json json = Json::parse(document.text());
  json["buffers"][0]["byteLength"] = 999;
  const auto result = read_gltf(json.dump());
  EXPECT_THAT(result.scene.faces, SizeIs(1));
  EXPECT_THAT(issues_of(result, ReadIssueKind::ParseError),
              ElementsAre("the buffer states 999 bytes, 36 are there @/buffers/0"));
}

}  // namespace
}  // namespace rad::tests
