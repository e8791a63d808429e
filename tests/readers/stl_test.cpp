#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::issue_text;

std::filesystem::path fixtures() { return std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/stl"; }

ReadResult read_stl(std::string_view bytes) { return tests::read_text(bytes, "model.stl"); }

// A binary file of one triangle for each facet that is there, and a header that states `stated`.
std::string binary_stl(std::uint32_t stated, std::size_t present) {
  std::string bytes(80, ' ');
  const auto append = [&](auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
  append(stated);
  for (std::size_t i = 0; i < present; ++i) {
    for (const float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(number);
    append(std::uint16_t{0});
  }
  return bytes;
}

constexpr std::string_view kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(Stl, ReadsText) {
  const ReadResult result = read_file(fixtures() / "tetrahedron_text.stl");
  EXPECT_EQ(issue_text(result), "");
  const scene::Scene& scene = result.scene;
  EXPECT_EQ(scene.faces.size(), 4u);
  EXPECT_EQ(scene.vertices.size(), 12u);
  EXPECT_THAT(scene.objects, ElementsAre("", "tetrahedron one"));
  EXPECT_EQ(scene.faces[1].source.record, 9u);
  EXPECT_EQ(scene.vertex_records[0], 4u);
  EXPECT_EQ(scene.sections[0].kind, scene::RecordKind::Line);
  EXPECT_TRUE(scene.single_precision && scene.triangles_only && scene.splits_vertices);
}

TEST(Stl, ReadsABinaryFileThatBeginsWithSolid) {
  const ReadResult result = read_file(fixtures() / "tetrahedron_binary.stl");
  EXPECT_EQ(issue_text(result), "");
  const scene::Scene& scene = result.scene;
  ASSERT_EQ(scene.faces.size(), 4u);
  EXPECT_EQ(scene.faces[1].source.record, 134u);
  EXPECT_EQ(scene.vertex_records[1], 84u + 24u);
  EXPECT_EQ(scene.vertices[1], dvec3(0, 1, 0));
  EXPECT_EQ(scene.sections[0].kind, scene::RecordKind::ByteOffset);
}

TEST(Stl, BothKindsHoldTheSameTetrahedron) {
  EXPECT_EQ(read_file(fixtures() / "tetrahedron_text.stl").scene.vertices,
            read_file(fixtures() / "tetrahedron_binary.stl").scene.vertices);
}

TEST(Stl, SeveralSolidsAreSeveralObjects) {
  const std::string facet(kFacet);
  const ReadResult result = read_stl("solid a\n" + facet + "endsolid a\nsolid b\n" + facet + facet +
                                     "endsolid\nsolid\n" + facet + "endsolid\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_THAT(result.scene.objects, ElementsAre("", "a", "b"));
  ASSERT_EQ(result.scene.faces.size(), 4u);
  EXPECT_EQ(result.scene.faces[2].object, 2u);
  EXPECT_EQ(result.scene.faces[3].object, 0u);
}

TEST(Stl, ReadsKeywordsInAnyCaseAndOnOneLine) {
  const ReadResult result = read_stl(
      "SOLID x\r\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET\r\nENDSOLID "
      "x\r\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.faces.size(), 1u);
}

TEST(Stl, EmptyFilesOfBothKindsAreSound) {
  EXPECT_EQ(issue_text(read_stl(binary_stl(0, 0))), "");
  EXPECT_EQ(issue_text(read_stl("solid nothing\nendsolid nothing\n")), "");
}

TEST(Stl, KeepsWholeFacetsOfATruncatedBinaryFile) {
  const std::string bytes = binary_stl(3, 3);
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    const ReadResult result = read_stl(std::string_view(bytes).substr(0, size));
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
    EXPECT_EQ(result.scene.faces.size(), size < 84 ? 0 : (size - 84) / 50);
    EXPECT_EQ(result.issues.all().size(), 1u) << size;
  }
  EXPECT_EQ(issue_text(read_stl(std::string_view(bytes).substr(0, 150))),
            "byte 150: the file ends after 1 whole facets, its header states 3\n");
  EXPECT_THAT(issue_text(read_stl(binary_stl(1, 2))), HasSubstr("byte 134: the header states 1 facets"));
}

TEST(Stl, LivesThroughTruncationOfText) {
  const std::string text = "solid a\n" + std::string(kFacet) + std::string(kFacet) + "endsolid a\n";
  for (std::size_t size = 1; size < text.size(); ++size) {
    const ReadResult result = read_stl(std::string_view(text).substr(0, size));
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
    EXPECT_LE(result.scene.faces.size(), 2u);
    const bool complete = size >= text.find("endsolid") + 8;
    EXPECT_EQ(result.issues.all().empty(), complete) << size << issue_text(result);
  }
}

TEST(Stl, LeavesOutFacetsThatAreNotTriangles) {
  const ReadResult result = read_stl(
      "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 "
      "1 0\n"
      "vertex 0 1 1\nendfacet\nvertex 1 1 1\nendfacet\ncolour red\nendsolid\n");
  EXPECT_EQ(result.scene.faces.size(), 0u);
  EXPECT_EQ(issue_text(result),
            "line 2: a facet needs three vertices, this one has 2; it is left out\n"
            "line 6: a facet needs three vertices, this one has more than 3; it is left out\n"
            "line 13: a vertex stands outside a facet\nline 14: endfacet stands outside a facet\n"
            "line 15: 'colour' is not a statement of ASCII STL\n");
}

TEST(Stl, KeepsFacetsWithCoordinatesThatAreNoNumbers) {
  const ReadResult result =
      read_stl("solid a\nfacet normal nan nan nan\nvertex 0 0 0\nvertex 1 x 0\nvertex 1 nan\nendfacet\nendsolid\n");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_TRUE(std::isnan(result.scene.vertices[1].y));
  EXPECT_EQ(result.scene.vertices[1].z, 0.0);
  EXPECT_EQ(issue_text(result),
            "line 4: 'x' is not a number\nline 5: a vertex needs three coordinates, this one has 2\n");
}

TEST(Stl, StopsAtItsLimits) {
  Limits limits;
  limits.vertices = 5;
  const auto binary = tests::read_text(binary_stl(3, 3), "model.stl", "no-such-folder", limits);
  EXPECT_EQ(binary.scene.faces.size(), 1u);
  limits = {};
  limits.faces = 1;
  const std::string facet(kFacet);
  const auto text = tests::read_text("solid\n" + facet + facet + facet, "model.stl", "no-such-folder", limits);
  EXPECT_EQ(text.scene.faces.size(), 1u);
  EXPECT_EQ(text.issues.all().size(), 1u);
}

}  // namespace
}  // namespace rad::readers
