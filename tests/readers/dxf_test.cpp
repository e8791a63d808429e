#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/drawing_colour.h"
#include "scene/finding.h"
#include "scene/index_colour.h"
#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::issue_text;

/// Codes and values, one a line, of a text with blanks between them.
std::string lines_of(std::string_view text) {
  std::string lines(text);
  std::ranges::replace(lines, ' ', '\n');
  return lines + "\n";
}

ReadResult read_dxf(std::string_view text) { return tests::read_text(lines_of(text), "model.dxf"); }

ReadResult read_entities(const std::string& entities, const std::string& before = "") {
  return read_dxf(before + "0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

std::vector<dvec3> points_of(const scene::Scene& scene, scene::FaceId face) {
  std::vector<dvec3> points;
  for (const scene::VertexId id : scene.corners_of(scene.loops[scene.faces[face].first_loop])) {
    const dvec3& p = scene.vertices[id];
    points.emplace_back(std::round(p.x * 1e9) / 1e9 + 0.0, std::round(p.y * 1e9) / 1e9 + 0.0,
                        std::round(p.z * 1e9) / 1e9 + 0.0);
  }
  return points;
}

/// Twice the vector area of all faces of a closed solid is zero, its volume positive where faces look outwards.
double volume(const scene::Scene& scene) {
  double sum = 0;
  for (scene::FaceId face = 0; face < scene.faces.size(); ++face) {
    const auto points = points_of(scene, face);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      sum += glm::dot(points[0], glm::cross(points[i], points[i + 1]));
    }
  }
  return sum / 6;
}

const std::string kTriangle = "0 3DFACE 5 2F 8 walls 10 0 20 0 30 0 11 1 21 0 31 0 12 0 22 1 32 0 13 0 23 1 33 0";
const std::string kQuad = "0 3DFACE 8 walls 10 0 20 0 30 5 11 1 21 0 31 5 12 1 22 1 32 5 13 0 23 1 33 5";

TEST(Dxf, ReadsThreeDFacesWithLayerAndHandle) {
  const ReadResult result = read_entities(kTriangle + " " + kQuad);
  EXPECT_EQ(issue_text(result), "");
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_THAT(points_of(result.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)));
  EXPECT_EQ(points_of(result.scene, 1).size(), 4u);
  EXPECT_EQ(result.scene.objects[result.scene.faces[0].object], "walls");
  EXPECT_EQ(result.scene.up, scene::UpAxis::Z);
  EXPECT_EQ(scene::reference_to(result.scene, 0).ref, "model.dxf:6 (handle 2F)");
  EXPECT_EQ(scene::reference_to(result.scene, 1).entity, "");
}

TEST(Dxf, TakesTheUnitFromTheHeader) {
  const auto metres = [](const std::string& code) {
    return read_entities(kTriangle, "0 SECTION 2 HEADER 9 $MEASUREMENT 70 1 9 $INSUNITS 70 " + code + " 0 ENDSEC ")
        .scene.metres_per_unit;
  };
  EXPECT_EQ(metres("1"), 0.0254);
  EXPECT_EQ(metres("4"), 0.001);
  EXPECT_EQ(metres("6"), 1.0);
  EXPECT_EQ(metres("0"), std::nullopt);
  EXPECT_EQ(metres("99"), std::nullopt);
  EXPECT_EQ(read_entities(kTriangle).scene.metres_per_unit, std::nullopt);
}

TEST(Dxf, ColoursComeFromEntityLayerAndTrueColour) {
  const std::string layers =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 walls 62 1 0 LAYER 2 Floor 62 7 420 1193046 0 ENDTAB 0 ENDSEC ";
  const ReadResult result = read_entities(
      "0 3DFACE 8 WALLS 10 0 20 0 30 0 0 3DFACE 8 walls 62 5 10 0 20 0 30 0 0 3DFACE 8 floor 10 0 20 0 30 0", layers);
  const auto& scene = result.scene;
  ASSERT_EQ(scene.faces.size(), 3u);
  const auto material = [&](std::size_t face) { return scene.materials[scene.faces[face].material]; };
  EXPECT_EQ(material(0).name, "walls");
  EXPECT_EQ(material(0).reflectance, dvec3(scene::kWhitePaint, 0, 0));
  EXPECT_TRUE(material(0).reflectance_stated);
  EXPECT_EQ(material(1).name, "colour 5");
  EXPECT_EQ(material(1).reflectance, dvec3(0, 0, scene::kWhitePaint));
  EXPECT_EQ(material(2).name, "Floor");
  EXPECT_EQ(material(2).reflectance, scene::reflectance_of_colour(0x123456));
}

TEST(Dxf, ColourWheelHasHuesValuesAndPaleColours) {
  EXPECT_EQ(scene::colour_of_index(10), 0xFF0000u);
  EXPECT_EQ(scene::colour_of_index(11), 0xFF7F7Fu);
  EXPECT_EQ(scene::colour_of_index(14), 0x7F0000u);
  EXPECT_EQ(scene::colour_of_index(50), 0xFFFF00u);
  EXPECT_EQ(scene::colour_of_index(90), 0x00FF00u);
  EXPECT_EQ(scene::colour_of_index(170), 0x0000FFu);
  EXPECT_EQ(scene::colour_of_index(255), 0xFFFFFFu);
  EXPECT_EQ(scene::colour_of_index(-3), 0xFFFFFFu);
}

TEST(Dxf, LeavesOutWhatIsNotSeenAndCountsIt) {
  const std::string layers = "0 SECTION 2 TABLES 0 LAYER 2 off 62 -1 0 LAYER 2 frozen 70 1 62 1 0 ENDSEC ";
  const ReadResult result = read_entities(
      "0 3DFACE 8 off 10 0 0 3DFACE 8 FROZEN 10 0 0 3DFACE 8 a 60 1 10 0 0 3DFACE 8 a 67 1 10 0 0 TEXT 8 a 1 x",
      layers);
  EXPECT_EQ(result.scene.faces.size(), 0u);
  ASSERT_EQ(result.issues.all().size(), 3u);
  EXPECT_EQ(result.issues.all()[0].what, "entities that are hidden or on layers that are off or frozen");
  EXPECT_EQ(result.issues.all()[0].count, 3u);
  EXPECT_EQ(result.issues.all()[1].what, "entities in paper space");
  EXPECT_EQ(result.issues.all()[2].what, "TEXT entities");
}

TEST(Dxf, RaisesWallsOfLinesAndArcs) {
  const ReadResult result =
      read_entities("0 LINE 8 a 39 2 10 0 20 0 30 0 11 3 21 0 31 0 0 ARC 8 a 39 1 10 0 20 0 30 0 40 1 50 0 51 90");
  ASSERT_EQ(result.scene.faces.size(), 7u);
  EXPECT_THAT(points_of(result.scene, 0), ElementsAre(dvec3(0, 0, 0), dvec3(3, 0, 0), dvec3(3, 0, 2), dvec3(0, 0, 2)));
  EXPECT_EQ(points_of(result.scene, 1)[0], dvec3(1, 0, 0));
  EXPECT_EQ(points_of(result.scene, 6)[1], dvec3(0, 1, 0));
}

TEST(Dxf, CurvesWithoutThicknessAreCounted) {
  const ReadResult result = read_entities(
      "0 LINE 8 a 10 0 20 0 11 1 21 0 0 CIRCLE 8 a 10 0 20 0 40 1 0 LWPOLYLINE 8 a 90 2 10 0 20 0 10 1 20 1");
  EXPECT_EQ(result.scene.faces.size(), 0u);
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::UnsupportedContent), 3u);
  EXPECT_THAT(issue_text(result), HasSubstr("line 6: LINE entities without thickness (curves)"));
}

TEST(Dxf, ThickSolidsAndCirclesAreClosedAndLookOutwards) {
  const ReadResult box = read_entities("0 SOLID 8 a 39 3 10 0 20 0 30 1 11 2 21 0 31 1 12 0 22 2 32 1 13 2 23 2 33 1");
  EXPECT_EQ(box.scene.faces.size(), 6u);
  EXPECT_NEAR(volume(box.scene), 12, 1e-9);
  const ReadResult down =
      read_entities("0 SOLID 8 a 39 -3 10 0 20 0 30 1 11 2 21 0 31 1 12 0 22 2 32 1 13 2 23 2 33 1");
  EXPECT_NEAR(volume(down.scene), 12, 1e-9);
  const ReadResult cylinder = read_entities("0 CIRCLE 8 a 39 1 10 0 20 0 30 0 40 1");
  EXPECT_EQ(cylinder.scene.faces.size(), 26u);
  EXPECT_NEAR(volume(cylinder.scene), 12 * std::sin(M_PI / 12), 1e-6);
}

TEST(Dxf, ExtrusionDirectionTurnsPlanarEntities) {
  // Along -Y the axes of the object frame are X and Z.
  const ReadResult result =
      read_entities("0 SOLID 8 a 210 0 220 -1 230 0 10 0 20 0 30 2 11 1 21 0 31 2 12 0 22 1 32 2");
  EXPECT_THAT(points_of(result.scene, 0), ElementsAre(dvec3(0, -2, 0), dvec3(1, -2, 0), dvec3(0, -2, 1)));
}

TEST(Dxf, DividesBulgesOfPolylines) {
  // A half circle to the right of the chord, from (0, 0) by (1, -1) to (2, 0).
  const ReadResult result = read_entities("0 LWPOLYLINE 8 a 70 0 39 1 38 4 90 2 10 0 20 0 42 1 10 2 20 0");
  ASSERT_EQ(result.scene.faces.size(), 12u);
  EXPECT_EQ(points_of(result.scene, 5)[1], dvec3(1, -1, 4));
  EXPECT_EQ(points_of(result.scene, 11)[1], dvec3(2, 0, 4));
  const ReadResult closed = read_entities("0 LWPOLYLINE 8 a 70 1 39 1 90 3 10 0 20 0 10 2 20 0 10 0 20 1");
  EXPECT_EQ(closed.scene.faces.size(), 3u);
}

TEST(Dxf, ReadsPolyfaceMeshes) {
  const ReadResult result = read_entities(
      "0 POLYLINE 5 A1 8 a 66 1 70 64 71 4 72 2 0 VERTEX 8 a 70 192 10 0 20 0 30 0 0 VERTEX 70 192 10 1 20 0 30 0 "
      "0 VERTEX 70 192 10 1 20 1 30 0 0 VERTEX 70 192 10 0 20 1 30 0 "
      "0 VERTEX 70 128 71 1 72 -2 73 3 74 4 0 VERTEX 70 128 71 1 72 2 73 9 0 SEQEND " +
      kTriangle);
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_THAT(tests::outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(scene::reference_to(result.scene, 0).entity, "handle A1");
  EXPECT_THAT(issue_text(result), HasSubstr("vertex index 9 exceeds the 4 vertices"));
}

TEST(Dxf, ReadsPolygonMeshesOpenAndClosed) {
  std::string mesh = "0 POLYLINE 8 a 66 1 70 48 71 2 72 3";
  for (int m = 0; m < 2; ++m) {
    for (int n = 0; n < 3; ++n) {
      mesh += " 0 VERTEX 70 64 10 " + std::to_string(n) + " 20 " + std::to_string(n * n) + " 30 " + std::to_string(m);
    }
  }
  const ReadResult result = read_entities(mesh + " 0 SEQEND");
  ASSERT_EQ(result.scene.faces.size(), 3u);  // closed around, open along
  EXPECT_THAT(tests::outer_loop(result.scene, 0), ElementsAre(0, 3, 4, 1));
  EXPECT_THAT(tests::outer_loop(result.scene, 2), ElementsAre(2, 5, 3, 0));
  EXPECT_THAT(issue_text(read_entities(mesh + " 0 VERTEX 70 64 10 9 0 SEQEND")), HasSubstr("has 7 vertices"));
}

TEST(Dxf, ReadsTheCageOfMesh) {
  const ReadResult result = read_entities(
      "0 MESH 8 a 71 2 72 1 91 2 92 4 10 0 20 0 30 0 10 1 20 0 30 0 10 1 20 1 30 0 10 0 20 1 30 0 "
      "93 8 90 4 90 0 90 1 90 2 90 3 90 3 90 0 90 1 90 7 94 1 90 0 90 1 95 1 140 0.0 90 0");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_THAT(tests::outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(issue_text(result), HasSubstr("smoothing of MESH entities"));
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::IndexOutOfRange), 1u);
}

const std::string kBlock =
    "0 SECTION 2 BLOCKS 0 BLOCK 2 Door 10 1 20 0 30 0 0 3DFACE 5 7 8 0 62 0 10 1 20 0 30 0 11 2 21 0 31 0 12 1 22 1 32 "
    "0 "
    "0 ENDBLK 0 ENDSEC ";

TEST(Dxf, PlacesBlocksScaledTurnedAndInArrays) {
  const ReadResult result =
      read_entities("0 INSERT 5 3A 8 doors 62 3 2 DOOR 10 10 20 0 30 0 41 2 50 90 70 2 71 1 44 5", kBlock);
  EXPECT_EQ(issue_text(result), "");
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_THAT(points_of(result.scene, 0), ElementsAre(dvec3(10, 0, 0), dvec3(10, 2, 0), dvec3(9, 0, 0)));
  EXPECT_THAT(points_of(result.scene, 1), ElementsAre(dvec3(10, 5, 0), dvec3(10, 7, 0), dvec3(9, 5, 0)));
  const scene::Face& face = result.scene.faces[0];
  EXPECT_EQ(result.scene.objects[face.object], "doors");
  EXPECT_EQ(result.scene.groups[face.group], "DOOR");
  EXPECT_EQ(result.scene.materials[face.material].name, "colour 3");
  EXPECT_EQ(result.scene.entities[face.entity], "handle 7 in block DOOR, insert 3A");
}

TEST(Dxf, MirroredInsertsKeepTheFrontOfFaces) {
  const ReadResult result = read_entities("0 INSERT 8 a 2 Door 10 0 20 0 30 0 41 -1", kBlock);
  EXPECT_THAT(points_of(result.scene, 0), ElementsAre(dvec3(0, 1, 0), dvec3(-1, 0, 0), dvec3(0, 0, 0)));
}

TEST(Dxf, BlocksWithinThemselvesAndMissingBlocksAreRefused) {
  const std::string cycle =
      "0 SECTION 2 BLOCKS 0 BLOCK 2 A 0 INSERT 8 a 2 B 0 ENDBLK 0 BLOCK 2 B 0 INSERT 8 a 2 A 0 ENDBLK 0 ENDSEC ";
  EXPECT_THAT(issue_text(read_entities("0 INSERT 8 a 2 A", cycle)), HasSubstr("block 'A' is placed within itself"));
  EXPECT_THAT(issue_text(read_entities("0 INSERT 8 a 2 nothing")),
              HasSubstr("INSERT of block 'nothing', which does not exist"));
}

TEST(Dxf, InsertsThatGrowWithoutBoundStop) {
  std::string blocks = "0 SECTION 2 BLOCKS 0 BLOCK 2 B0 " + kTriangle + " 0 ENDBLK ";
  for (int i = 1; i < 40; ++i) {
    const std::string inner = " 0 INSERT 8 a 2 B" + std::to_string(i - 1);
    blocks += "0 BLOCK 2 B" + std::to_string(i) + inner + inner + " 0 ENDBLK ";
  }
  Limits limits;
  limits.instances = 1000;
  const ReadResult result =
      tests::read_text(lines_of(blocks + "0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 8 a 2 B39 0 ENDSEC 0 EOF"), "a.dxf",
                       "no-such-folder", limits);
  EXPECT_THAT(issue_text(result), HasSubstr("blocks are placed too often"));
  EXPECT_LE(result.scene.faces.size(), 1000u);
}

TEST(Dxf, BodiesOfAcisAreNamed) {
  const ReadResult result = read_entities("0 3DSOLID 5 8A 8 a 1 xyz 0 REGION 8 a");
  EXPECT_EQ(result.scene.faces.size(), 0u);
  EXPECT_THAT(issue_text(result), HasSubstr("line 6: 3DSOLID entities (ACIS bodies: convert them to meshes)"));
}

TEST(Dxf, ReportsDamageWithItsLine) {
  EXPECT_EQ(issue_text(read_dxf("0 SECTION 2 ENTITIES zero 3DFACE")), "line 5: 'zero' is not a group code\n");
  EXPECT_EQ(issue_text(read_dxf("0 SECTION 2 ENTITIES 0 ENDSEC")), "line 6: the file ends without EOF\n");
  const ReadResult result = read_entities("0 3DFACE 8 a 10 x 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0");
  EXPECT_EQ(issue_text(result), "line 10: 'x' is not a number\n");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_TRUE(std::isnan(result.scene.vertices[0].x));
  EXPECT_THAT(issue_text(tests::read_text("AutoCAD Binary DXF\r\n\x1a", "a.dxf")), HasSubstr("save as ASCII DXF"));
}

TEST(Dxf, PassesOverCommentsAndExtendedData) {
  const ReadResult result = tests::read_text(
      "999\r\na comment\r\n  0\r\nSECTION\r\n  2\r\nENTITIES\r\n  0\r\n3DFACE\r\n  8\r\nlayer with "
      "blanks\r\n1001\r\nACAD\r\n"
      "1010\r\n5\r\n 10\r\n0\r\n 20\r\n0\r\n 11\r\n1\r\n 21\r\n0\r\n 12\r\n1\r\n 22\r\n1\r\n  0\r\nENDSEC\r\n  "
      "0\r\nEOF\r\n",
      "model.txt");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.format, "dxf");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(result.scene.objects[1], "layer with blanks");
}

TEST(Dxf, LivesThroughTruncationAtEveryByte) {
  const std::string text =
      lines_of(kBlock + "0 SECTION 2 ENTITIES 0 INSERT 8 a 2 Door 10 0 20 0 " + kQuad + " 0 ENDSEC 0 EOF");
  for (std::size_t size = 0; size < text.size(); ++size) {
    const ReadResult result = tests::read_text(std::string_view(text).substr(0, size), "model.dxf");
    EXPECT_EQ(tests::broken_invariant(result.scene), "") << size;
    EXPECT_TRUE(!result.issues.all().empty() || size + 2 >= text.size()) << size;
  }
}

TEST(Dxf, ReadsTheFixture) {
  const ReadResult result = read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/dxf/room.dxf");
  EXPECT_EQ(issue_text(result), "");
  EXPECT_EQ(result.scene.metres_per_unit, 0.001);
  EXPECT_EQ(result.scene.faces.size(), 6u + 6u);
}

}  // namespace
}  // namespace rad::readers
