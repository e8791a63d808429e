#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "scene/drawing_colour.h"
#include "scene/finding.h"
#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;

/// "pointer: what" of every issue, one a line.
std::string issues_of(const ReadResult& result) {
  std::string text;
  for (const scene::ReadIssue& issue : result.issues.all()) text += issue.place.pointer + ": " + issue.what + "\n";
  return text;
}

std::string city(const std::string& geometry, const std::string& more = "", const std::string& version = "1.1") {
  return R"({"type": "CityJSON", "version": ")" + version +
         R"(", "vertices": [[0,0,0],[4,0,0],[4,4,0],[0,4,0],[1,1,0],[1,2,0],[2,2,0],[2,1,0]],)" + more +
         R"("CityObjects": {"a/b": {"type": "Building", "geometry": [)" + geometry + "]}}}";
}

ReadResult read_city(const std::string& geometry, const std::string& more = "") {
  return tests::read_text(city(geometry, more), "model.city.json");
}

const std::string kSquare = R"({"type": "MultiSurface", "lod": "1", "boundaries": [[[0,1,2,3],[4,5,6,7]]]})";

TEST(CityJson, ReadsSurfacesWithHoles) {
  const ReadResult result = read_city(kSquare);
  EXPECT_EQ(issues_of(result), "");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(result.scene.faces[0].loop_count, 2u);
  EXPECT_THAT(tests::outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(result.scene.vertices.size(), 8u);
  EXPECT_EQ(result.scene.metres_per_unit, 1.0);
  EXPECT_EQ(result.scene.up, scene::UpAxis::Z);
  EXPECT_EQ(result.scene.objects[result.scene.faces[0].object], "a/b");
  EXPECT_EQ(scene::reference_to(result.scene, 0).ref, "model.city.json#/CityObjects/a~1b/geometry/0/boundaries/0");
}

TEST(CityJson, ReadsTheFixture) {
  const ReadResult result =
      read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/cityjson/houses.city.json");
  EXPECT_EQ(issues_of(result),
            "/CityObjects/house/geometry/1: geometries of a coarser level of detail than another of their object\n");
  const scene::Scene& scene = result.scene;
  ASSERT_EQ(scene.faces.size(), 9u);
  EXPECT_EQ(scene.vertices[6], dvec3(1008, 2006, 10));
  EXPECT_EQ(scene.groups[scene.faces[1].group], "RoofSurface");
  EXPECT_EQ(scene.materials[scene.faces[2].material].name, "brick");
  EXPECT_EQ(scene.materials[scene.faces[2].material].reflectance, scene::reflectance_of_srgb({0.6, 0.2, 0.1}));
  EXPECT_EQ(scene.faces[1].material, 0u);
  // The template is twice as large, 3 to the right of vertex 1.
  const auto corners = scene.corners_of(scene.loops[scene.faces[7].first_loop]);
  EXPECT_EQ(scene.vertices[corners[0]], dvec3(1008 - 1 + 3, 2000, 5));
  EXPECT_EQ(scene.vertices[corners[2]], dvec3(1008 + 1 + 3, 2000, 9));
}

TEST(CityJson, NestsByTheTypeOfTheGeometry) {
  const ReadResult result =
      read_city(R"({"type": "CompositeSolid", "lod": 1, "boundaries": [[[[[0,1,2]],[[0,2,3]]]],[[[[4,5,6]]]]],)"
                R"("material": {"x": {"values": [[[null, 0]], [null]]}}})",
                R"("appearance": {"materials": [{"name": "m"}]},)");
  ASSERT_EQ(result.scene.faces.size(), 3u);
  EXPECT_EQ(scene::reference_to(result.scene, 1).pointer, "/CityObjects/a~1b/geometry/0/boundaries/0/0/1");
  EXPECT_EQ(result.scene.faces[0].material, 0u);
  EXPECT_EQ(result.scene.materials[result.scene.faces[1].material].name, "m");
  EXPECT_EQ(result.scene.faces[2].material, 0u);
  EXPECT_THAT(issues_of(read_city(R"({"type": "Solid", "boundaries": [[[0,1,2]]]})")),
              HasSubstr("not an array of vertex numbers"));
  EXPECT_THAT(issues_of(read_city(R"({"type": "MultiSurface", "boundaries": 3})")),
              HasSubstr("not nested as the type"));
}

TEST(CityJson, OneMaterialForAllAndThemes) {
  const ReadResult result = read_city(
      R"({"type": "MultiSurface", "boundaries": [[[0,1,2]]], "material": {"b": {"value": 1}, "a": {"value": 0}}})",
      R"("appearance": {"default-theme-material": "b", "materials": [{"name": "m"}, {"name": "m", "transparency": 0.5, "emissiveColor": [1,0,0]}]},)");
  EXPECT_EQ(result.scene.materials[result.scene.faces[0].material].name, "m (2)");
  EXPECT_EQ(issues_of(result),
            "/appearance/materials/1: emissive colours, which have no unit\n/appearance/materials/1: transparency of "
            "materials\n"
            "/CityObjects/a~1b/geometry/0: further themes of materials\n");
}

TEST(CityJson, KeepsImagesAndTheirCoordinates) {
  const ReadResult result = read_city(
      R"({"type": "MultiSurface", "boundaries": [[[0,1,2]], [[0,2,3]]], "texture": {"t": {"values": [[[0, 0, 1, 2]], [[null]]]}}})",
      R"("appearance": {"textures": [{"type": "PNG", "image": "wall.png"}], "vertices-texture": [[0,0],[1,0],[1,1]]},)");
  EXPECT_EQ(tests::broken_invariant(result.scene), "");
  const scene::Material& material = result.scene.materials[result.scene.faces[0].material];
  ASSERT_TRUE(material.texture);
  EXPECT_EQ(material.texture->image->path, "wall.png");
  EXPECT_TRUE(scene::has_texture_coordinates(result.scene, result.scene.faces[0]));
  EXPECT_FALSE(scene::has_texture_coordinates(result.scene, result.scene.faces[1]));
}

TEST(CityJson, ReadsTheFinestLevelOfDetail) {
  const ReadResult result = read_city(R"({"type": "MultiSurface", "lod": 1, "boundaries": [[[0,1,2]]]},)"
                                      R"({"type": "MultiSurface", "lod": "2.2", "boundaries": [[[0,1,3]],[[0,1,2]]]},)"
                                      R"({"type": "MultiPoint", "lod": "2.2", "boundaries": [0,1]})");
  EXPECT_EQ(result.scene.faces.size(), 2u);
  EXPECT_EQ(issues_of(result),
            "/CityObjects/a~1b/geometry/0: geometries of a coarser level of detail than another of their object\n"
            "/CityObjects/a~1b/geometry/2: MultiPoint geometries\n");
}

TEST(CityJson, ReadsTheLevelOfDetailThatTheUserChooses) {
  const std::string text = city(R"({"type": "MultiSurface", "lod": 1, "boundaries": [[[0,1,2]]]},)"
                                R"({"type": "MultiSurface", "lod": "2.2", "boundaries": [[[0,1,3]],[[0,1,2]]]})");
  const auto faces = [&](double level) {
    Input input{"a.city.json", ".", text, {}, {}};
    input.choices.level_of_detail = level;
    return read_bytes(input).scene.faces.size();
  };
  EXPECT_EQ(faces(1), 1u);
  EXPECT_EQ(faces(2), 2u);
  EXPECT_EQ(faces(2.2), 2u);
  EXPECT_EQ(faces(3), 0u);
}

TEST(CityJson, LeavesOutSurfacesWithBadIndices) {
  const ReadResult result = read_city(
      R"({"type": "MultiSurface", "boundaries": [[[0,1,8]], [[0,-1,2]], [[0,1.5,2]], [], [[0,1,2]], [[0,18446744073709551615,1]]]})");
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::IndexOutOfRange), 3u);
  EXPECT_THAT(issues_of(result),
              HasSubstr("/CityObjects/a~1b/geometry/0/boundaries/0/0: vertex index 8 is outside the 8 vertices"));
}

TEST(CityJson, ReportsWhatIsNoCityJson) {
  EXPECT_THAT(issues_of(tests::read_text("[1]", "a.city.json")), HasSubstr("so this is not CityJSON"));
  EXPECT_THAT(issues_of(tests::read_text(R"({"CityObjects": {}, "type": "x"})", "a.json")),
              HasSubstr("\"type\" is not \"CityJSON\""));
  EXPECT_THAT(issues_of(tests::read_text(city(kSquare, "", "3.0"), "a.json")),
              HasSubstr("version '3.0' of CityJSON is not read"));
  EXPECT_EQ(tests::read_text(city(kSquare, "", "1.0"), "a.json").scene.faces.size(), 1u);
  EXPECT_EQ(tests::read_text(city(kSquare, "", "2.0.1"), "a.json").scene.faces.size(), 1u);
}

TEST(CityJson, VerticesThatCannotBeReadAreNaN) {
  const ReadResult result = tests::read_text(
      R"({"type": "CityJSON", "version": "1.0", "CityObjects": {}, "vertices": [[1,2,"x"], [1,2], 5]})", "a.json");
  ASSERT_EQ(result.scene.vertices.size(), 3u);
  EXPECT_EQ(result.scene.vertices[0].y, 2);
  EXPECT_TRUE(std::isnan(result.scene.vertices[0].z));
  EXPECT_EQ(issues_of(result),
            "/vertices/0: a coordinate is not a number\n/vertices/1: a vertex is not an array of three numbers\n"
            "/vertices/2: a vertex is not an array of three numbers\n");
}

TEST(CityJson, InstancesWithoutTheirTemplateAreRefused) {
  EXPECT_THAT(issues_of(read_city(R"({"type": "GeometryInstance", "template": 0, "boundaries": [0]})")),
              HasSubstr("an instance lacks"));
  const std::string matrix = R"("transformationMatrix": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})";
  const std::string templates =
      R"("geometry-templates": {"templates": [{"type": "MultiSurface", "boundaries": [[[0,1,2]]]}], "vertices-templates": [[0,0,0],[1,0,0]]},)";
  EXPECT_THAT(
      issues_of(read_city(R"({"type": "GeometryInstance", "template": 9, "boundaries": [0], )" + matrix, templates)),
      HasSubstr("/geometry-templates/templates/9, which does not exist"));
  EXPECT_THAT(
      issues_of(read_city(R"({"type": "GeometryInstance", "template": 0, "boundaries": [0], )" + matrix, templates)),
      HasSubstr("vertex index 2 is outside the 2 vertices"));
}

TEST(CityJson, LivesThroughTruncationAtEveryByte) {
  const std::string text = city(kSquare);
  for (std::size_t size = 1; size < text.size(); ++size) {
    const ReadResult result = tests::read_text(std::string_view(text).substr(0, size), "a.city.json");
    EXPECT_EQ(tests::broken_invariant(result.scene), "") << size;
    EXPECT_EQ(result.issues.all().size(), 1u) << size;
  }
}

}  // namespace
}  // namespace rad::readers
