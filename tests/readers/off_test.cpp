#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::issue_text;
using tests::outer_loop;

ReadResult read_off(std::string_view text) { return tests::read_text(text, "model.off"); }

constexpr std::string_view kVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, ReadsCountsOnTheLineOfTheHeader) {
  const ReadResult result = read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/off/tetrahedron.off");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.vertices.size(), 4u);
  ASSERT_EQ(result.scene.faces.size(), 4u);
  EXPECT_EQ(result.scene.faces[0].source.record, 8u);
  EXPECT_EQ(result.scene.vertex_records[0], 3u);
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(0, 2, 1));
}

TEST(Off, ReadsPolygonsAfterCommentsAndBlankLines) {
  const ReadResult result =
      read_off("OFF # x\r\n\r\n# y\r\n4 2\r\n" + std::string(kVertices) + "\n4 0 1 2 3 # square\n2 0 1\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(result.scene.faces[0].source.record, 10u);
  EXPECT_THAT(outer_loop(result.scene, 1), ElementsAre(0, 1));
}

TEST(Off, ReadsTheVariantsThatOnlyAddToVertices) {
  for (const char* header : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF", ""}) {
    const ReadResult result = read_off(std::string(header) + "\n1 0 0\n1 2 3 0 0 1 255 0 0\n");
    EXPECT_EQ(issue_text(result), "") << header;
    ASSERT_EQ(result.scene.vertices.size(), 1u) << header;
    EXPECT_EQ(result.scene.vertices[0], scene::dvec3(1, 2, 3)) << header;
  }
}

TEST(Off, RefusesOtherDimensionsAndBinaryInWords) {
  EXPECT_EQ(issue_text(read_off("4OFF\n1 0 0\n0 0 0 1\n")),
            "line 1: 4OFF (four coordinates) is not read; export OFF\n");
  EXPECT_THAT(issue_text(read_off("nOFF\n3 1 0 0\n")), HasSubstr("nOFF"));
  EXPECT_THAT(issue_text(read_off("OFF BINARY\n\x01\x02")), HasSubstr("binary OFF is not read"));
  EXPECT_THAT(issue_text(read_off("hello\n")), HasSubstr("'hello' is not an OFF header"));
}

TEST(Off, RefusesCountsThatTheFileCannotHold) {
  const ReadResult result = read_off("OFF\n353535235358 6 0\n0 0 0\n");
  EXPECT_EQ(issue_text(result),
            "line 2: the header states 353535235358 vertices, the 9 bytes that follow cannot hold them\n");
  EXPECT_EQ(result.scene.vertices.size(), 0u);
  EXPECT_EQ(read_off("OFF\n-1 6 0\n").issues.all().size(), 1u);
  EXPECT_EQ(read_off("OFF\n1\n").issues.all().size(), 1u);
  EXPECT_EQ(read_off("OFF\n").issues.all().size(), 1u);
  const ReadResult faces = read_off("OFF\n4 999999999999 0\n" + std::string(kVertices) + "3 0 1 2\n");
  EXPECT_EQ(faces.scene.faces.size(), 1u);
  EXPECT_EQ(faces.issues.all().size(), 2u);
}

TEST(Off, LeavesOutFacesWithBadIndices) {
  const ReadResult result =
      read_off("OFF\n4 6 0\n" + std::string(kVertices) + "3 0 1 4\n3 -1 0 1\n3 0 1\n3 0 1 x\nx\n3 0 1 2\n");
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::IndexOutOfRange), 2u);
  EXPECT_THAT(issue_text(result), HasSubstr("line 7: vertex index 4 is outside the 4 vertices, which count from 0\n"
                                            "line 8: vertex index -1 is negative\n"));
}

TEST(Off, KeepsVerticesThatCannotBeRead) {
  const ReadResult result = read_off("OFF\n3 1 0\n0 0\nx 0 0\n0 nan 0\n3 0 1 2\n");
  ASSERT_EQ(result.scene.vertices.size(), 3u);
  EXPECT_TRUE(std::isnan(result.scene.vertices[0].z));
  EXPECT_EQ(result.issues.all().size(), 2u);
  EXPECT_EQ(result.scene.faces.size(), 1u);
}

TEST(Off, LivesThroughTruncationAtEveryByte) {
  const std::string text = "OFF\n4 2 0\n" + std::string(kVertices) + "4 0 1 2 3\n3 0 1 2\n";
  for (std::size_t size = 1; size < text.size() - 1; ++size) {
    const ReadResult result = read_off(std::string_view(text).substr(0, size));
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
    EXPECT_GE(result.issues.all().size(), 1u) << size;
    EXPECT_LE(result.issues.all().size(), 3u) << size;
  }
  EXPECT_EQ(issue_text(read_off(std::string_view(text).substr(0, 34))), "line 6: the file ends after 0 of 2 faces\n");
}

}  // namespace
}  // namespace rad::readers
