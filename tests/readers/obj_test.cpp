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
using tests::issue_count;
using tests::issue_text;
using tests::outer_loop;

ReadResult read_obj(std::string_view text) { return tests::read_text(text, "model.obj"); }

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsVerticesAndPolygonsWithTheirLines) {
  const ReadResult result = read_obj(std::string(kSquare) + "# a comment\n\n \tf 1 2 3 4\nf 1 2 3\n");
  EXPECT_EQ(issue_text(result), "");
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_EQ(result.scene.format, "obj");
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(result.scene.faces[0].source.record, 7u);
  EXPECT_EQ(result.scene.faces[1].source.record, 8u);
  EXPECT_THAT(result.scene.vertex_records, ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(result.scene.sections[0].kind, scene::RecordKind::Line);
  EXPECT_FALSE(result.scene.single_precision);
}

TEST(Obj, ReadsEveryFormOfCorner) {
  const ReadResult result =
      read_obj(std::string(kSquare) +
               "f 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\nf -4 -3 -2\nf 1// 2/ 3//\nfo 1 2 3\n");
  EXPECT_EQ(issue_text(result), "");
  ASSERT_EQ(result.scene.faces.size(), 6u);
  for (scene::FaceId face = 0; face < 6; ++face) EXPECT_THAT(outer_loop(result.scene, face), ElementsAre(0, 1, 2));
}

TEST(Obj, NegativeIndicesCountFromTheVerticesReadSoFar) {
  const ReadResult result = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 5 5 5\nf -1 -2 -3\n");
  EXPECT_THAT(outer_loop(result.scene, 0), ElementsAre(2, 1, 0));
  EXPECT_THAT(outer_loop(result.scene, 1), ElementsAre(3, 2, 1));
}

TEST(Obj, TakesVerticesThatFollowTheirFacesAndKeepsTheOrderOfFaces) {
  const ReadResult result =
      read_obj("o a\nusemtl red\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\no b\nusemtl blue\nf -1 -2 -3\nf 1 2 4\n");
  EXPECT_THAT(issue_text(result), HasSubstr("line 10: vertex index 4 exceeds the 3 vertices of the file\n"));
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_EQ(result.scene.faces[0].source.record, 3u);
  EXPECT_EQ(result.scene.objects[result.scene.faces[0].object], "a");
  EXPECT_EQ(result.scene.materials[result.scene.faces[0].material].name, "red");
  EXPECT_EQ(result.scene.objects[result.scene.faces[1].object], "b");
  EXPECT_EQ(result.scene.materials[result.scene.faces[1].material].name, "blue");
  EXPECT_THAT(outer_loop(result.scene, 1), ElementsAre(2, 1, 0));
}

TEST(Obj, LeavesOutFacesWithBadIndicesAndSaysWhy) {
  const ReadResult result =
      read_obj(std::string(kSquare) + "f 0 1 2\nf 1 2 9\nf -5 1 2\nf 1 99999999999999999999 2\nf 1 2 3\n");
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(issue_count(result, ReadIssueKind::IndexOutOfRange), 4u);
  EXPECT_THAT(issue_text(result), HasSubstr("line 5: vertex index 0 is not valid, vertices count from 1\n"));
  EXPECT_THAT(issue_text(result), HasSubstr("line 6: vertex index 9 exceeds the 4 vertices of the file\n"));
  EXPECT_THAT(issue_text(result), HasSubstr("line 7: vertex index -5 reaches before the first of the 4 vertices"));
}

TEST(Obj, KeepsFacesOfFewerThanThreeCorners) {
  const ReadResult result = read_obj(std::string(kSquare) + "f 1\nf 2 3\nf\n");
  EXPECT_EQ(result.scene.faces.size(), 2u);
  EXPECT_EQ(issue_text(result), "line 7: a face names no vertex; it is left out\n");
}

TEST(Obj, JoinsContinuedLines) {
  const ReadResult result = read_obj("v 0 \\\n0 0\nv 1 0 0\r\nv 0 1 0\nf 1 \\\r\n 2 \\\n 3\nf 3 2 1\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_THAT(result.scene.vertex_records, ElementsAre(1, 3, 4));
  EXPECT_EQ(result.scene.faces[0].source.record, 5u);
  EXPECT_EQ(result.scene.faces[1].source.record, 8u);
}

TEST(Obj, KeepsAVertexThatCannotBeReadSoThatIndicesDoNotShift) {
  const ReadResult result = read_obj("v 1 2\nv 1 x 3\nv\nv 1,5 2 3\nv 0 0 1 0.5 0.5 0.5\nf 1 2 5\n");
  ASSERT_EQ(result.scene.vertices.size(), 5u);
  EXPECT_EQ(result.scene.vertices[0].y, 2.0);
  EXPECT_TRUE(std::isnan(result.scene.vertices[0].z));
  EXPECT_TRUE(std::isnan(result.scene.vertices[1].y));
  EXPECT_EQ(result.scene.vertices[1].z, 3.0);
  EXPECT_EQ(issue_text(result),
            "line 1: a vertex needs three coordinates, this one has 2\nline 2: 'x' is not a number\n"
            "line 3: a vertex needs three coordinates, this one has 0\nline 4: '1,5' is not a number\n");
  EXPECT_EQ(result.scene.faces.size(), 1u);
}

TEST(Obj, PassesOnCoordinatesThatAreNotFinite) {
  const ReadResult result = read_obj("v nan inf -inf\nv 1.#IND 1e999 +NaN\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_TRUE(std::isnan(result.scene.vertices[0].x));
  EXPECT_TRUE(std::isinf(result.scene.vertices[1].y));
}

TEST(Obj, NamesObjectsGroupsAndMaterials) {
  const ReadResult result =
      read_obj(std::string(kSquare) +
               "f 1 2 3\no Chair #1\ng  seat\tback\nusemtl dark oak\nf 1 2 3\no\ng\nusemtl dark oak\nf 1 2 3\n");
  const scene::Scene& scene = result.scene;
  EXPECT_THAT(scene.objects, ElementsAre("", "Chair #1"));
  EXPECT_THAT(scene.groups, ElementsAre("", "seat back"));
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[1].name, "dark oak");
  EXPECT_FALSE(scene.materials[1].reflectance_stated);
  EXPECT_EQ(scene.faces[0].material, 0u);
  EXPECT_EQ(scene.faces[1].object, 1u);
  EXPECT_EQ(scene.faces[2].object, 0u);
  EXPECT_EQ(scene.faces[2].group, 0u);
  EXPECT_EQ(scene.faces[2].material, 1u);
}

TEST(Obj, GroupsNameObjectsUntilTheFirstObject) {
  const ReadResult result = read_obj(std::string(kSquare) + "g a\nf 1 2 3\no b\nf 1 2 3\ng c\nf 1 2 3\n");
  EXPECT_THAT(result.scene.objects, ElementsAre("", "a", "b"));
  EXPECT_EQ(result.scene.faces[0].object, 1u);
  EXPECT_EQ(result.scene.faces[2].object, 2u);
  EXPECT_EQ(result.scene.groups[result.scene.faces[2].group], "c");
}

TEST(Obj, NamesMaterialsThatNoLibraryDefinesOnce) {
  const ReadResult result =
      read_obj(std::string(kSquare) + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl a\nf 1 2 3\n");
  EXPECT_EQ(issue_text(result), "line 5: no material library defines 'a', 'b'\n");
  EXPECT_EQ(result.issues.all()[0].kind, ReadIssueKind::MissingResource);
  EXPECT_EQ(result.issues.all()[0].count, 2u);
}

TEST(Obj, CountsContentThatIsNotASurfaceOncePerKind) {
  const ReadResult result =
      read_obj(std::string(kSquare) +
               "vn 0 0 1\nvt 0 0\ns 1\nlod 1\nshadow_obj x.obj\nvp 1 2\np 1\np 2\nl 1 2\ncurv 0 1 1 2\n"
               "surf 0 1 0 1 1\ncall other.obj\ncsh rm -r x\nend\nf 1 2 3\n");
  EXPECT_EQ(issue_count(result, ReadIssueKind::UnsupportedContent), 6u);
  EXPECT_EQ(result.issues.all().size(), 6u);
  EXPECT_EQ(result.issues.all()[0].count, 2u);
  EXPECT_EQ(result.issues.all()[0].place.line, 11u);
}

TEST(Obj, NamesOnlyAHandfulOfUnknownKeywords) {
  std::string text(kSquare);
  for (int i = 0; i < 50; ++i) text += "word" + std::to_string(i) + " 1\n";
  const ReadResult result = read_obj(text);
  EXPECT_EQ(result.issues.all().size(), 6u);
  EXPECT_EQ(result.issues.all().back().count, 45u);
}

TEST(Obj, TakesAUnitFromTheHeadOfTheFileOnly) {
  const std::string body(kSquare);
  EXPECT_EQ(read_obj("# File units = meters\n" + body).scene.metres_per_unit, 1.0);
  EXPECT_EQ(read_obj("# units: mm\r\n" + body).scene.metres_per_unit, 0.001);
  EXPECT_EQ(read_obj("#Units: Inches\n#units = inch\n" + body).scene.metres_per_unit, 0.0254);
  EXPECT_FALSE(read_obj("# units: mm\n# units: cm\n" + body).scene.metres_per_unit);
  EXPECT_FALSE(read_obj("# units of measure are mm\n# unit: parsec\n" + body).scene.metres_per_unit);
  EXPECT_FALSE(read_obj(body + "# units: mm\n").scene.metres_per_unit);
}

TEST(Obj, ReportsNothingOfTheCommentOfRadfix) {
  const ReadResult result = read_obj("# radfix T=0.0001 h=1.5e-07 origin=0 0 0\n" + std::string(kSquare) + "f 1 2 3\n");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.faces.size(), 1u);
}

TEST(Obj, RefusesWhatIsNotAnObj) {
  EXPECT_EQ(issue_text(read_obj(std::string_view("v 0 0 0\n\0\0\0", 11))), "byte 8: OBJ is text, this file is not\n");
  EXPECT_THAT(issue_text(read_obj("hello world\n")), HasSubstr("line 1: the file holds no statement of OBJ\n"));
  EXPECT_EQ(issue_text(read_obj("# nothing here\n")), "");
}

TEST(Obj, RefusesCornersThatAreNoIndices) {
  const ReadResult result = read_obj(std::string(kSquare) + "f 1 two 3\nf 1 2/x 3\nf / 2 3\nf 1.5 2 3\n");
  EXPECT_EQ(result.scene.faces.size(), 0u);
  EXPECT_EQ(issue_count(result, ReadIssueKind::ParseError), 4u);
}

TEST(Obj, StopsAtItsLimits) {
  Limits limits;
  limits.vertices = 3;
  const auto few = tests::read_text(kSquare, "model.obj", "no-such-folder", limits);
  EXPECT_EQ(few.scene.vertices.size(), 3u);
  EXPECT_EQ(issue_text(few), "line 4: the limit of 3 vertices is reached; the rest is left out\n");
  limits = {};
  limits.face_corners = 3;
  const auto small =
      tests::read_text(std::string(kSquare) + "f 1 2 3 4\nf 1 2 3\n", "model.obj", "no-such-folder", limits);
  EXPECT_EQ(small.scene.faces.size(), 1u);
  limits = {};
  limits.faces = 1;
  const auto waiting =
      tests::read_text("f 1 2 3\nf 1 2 3\n" + std::string(kSquare), "model.obj", "no-such-folder", limits);
  EXPECT_EQ(waiting.scene.faces.size(), 1u);
  limits = {};
  limits.line_bytes = 8;
  const auto line = tests::read_text("v 0 0 0\nv 1 1 1 1 1 1\nv 2 2 2\n", "model.obj", "no-such-folder", limits);
  EXPECT_EQ(line.scene.vertices.size(), 2u);
  EXPECT_THAT(issue_text(line), HasSubstr("longer than the limit of 8 bytes"));
}

TEST(Obj, LivesThroughTruncationAtEveryByte) {
  const std::string text = "# x\nmtllib no.mtl\no a\nv 0 0 0\nv 1 0 \\\n 0\nv 1 1 0\ng b\nusemtl c\nf 1/1 2/2 -1/3\n";
  for (std::size_t size = 1; size < text.size(); ++size) {
    const ReadResult result = read_obj(std::string_view(text).substr(0, size));
    EXPECT_EQ(tests::broken_invariant(result.scene), "") << size;
    EXPECT_LE(result.issues.all().size(), 3u) << size;
  }
}

}  // namespace
}  // namespace rad::readers
