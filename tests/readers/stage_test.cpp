// Stage files: what becomes of one, and that nothing a hostile one says does harm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/stage_record.h"
#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using nlohmann::json;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;

// A square of two triangles in the plane z = 0, after Coplanar.
json square() {
  return json::parse(R"({
    "format": "radfix-stage", "version": 1, "generator": "test", "stage": "coplanar", "incomplete": false,
    "lattice": {"pitch": 0.25, "origin": [1, 0, 0]}, "tolerance": 8, "workTolerance": 33.5, "overlaps": "resolved", "vertices": [],
    "metresPerUnit": 0.5, "up": "z",
    "materials": [{"name": "", "reflectance": [0.5, 0.5, 0.5], "reflectanceStated": false, "emission": [0, 0, 0],
                   "emissionUnit": "exitance", "doubleSided": false},
                  {"name": "lamp", "reflectance": [0.1, 0.2, 0.3], "reflectanceStated": true, "emission": [4, 5, 6],
                   "emissionUnit": "luminance", "doubleSided": true}],
    "objects": ["", "floor"], "groups": [""],
    "sources": [{"file": "room.obj", "pointer": "", "record": "line"}],
    "points": [[0, 0, 0], [4000, 0, 0], [4000, 4000, 0], [0, 4000, 0]],
    "planes": [{"normal": [0, 0, 1], "offset": 0, "area": 16000000, "slits": [[0, 2]], "points": [0]}],
    "faces": [{"loops": [[0, 1, 2, 3]], "material": 1, "object": 1, "group": 0, "sources": [[0, 7], [0, 9]],
               "plane": 0, "along": true, "surfaceRank": 3, "triangles": [[0, 1, 2], [0, 2, 3]]}],
    "ledger": [{"stage": "grouper", "operation": "weld", "rules": ["RL302"], "count": 2, "largestMovement": 0.5,
                "areaChange": null}]})");
}

ReadResult read(const json& stage) { return tests::read_text(stage.dump(), "model.stage.json"); }

TEST(Stage, HoldsWhatAModelBetweenFiltersHas) {
  const ReadResult result = read(square());
  EXPECT_EQ(tests::issue_text(result), "");
  const scene::Scene& scene = result.scene;
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_EQ(scene.format, "stage");
  ASSERT_EQ(scene.faces.size(), 2u);
  EXPECT_THAT(tests::outer_loop(scene, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(tests::outer_loop(scene, 1), ElementsAre(0, 2, 3));
  EXPECT_EQ(scene.vertices[1], geom::dvec3(1001, 0, 0));
  EXPECT_EQ(scene.materials[scene.faces[0].material].name, "lamp");
  EXPECT_EQ(scene.objects[scene.faces[0].object], "floor");
  EXPECT_EQ(scene.sections[scene.faces[0].source.section].file, "room.obj");
  EXPECT_EQ(scene.faces[0].source.record, 7u);
  EXPECT_EQ(scene.metres_per_unit, 0.5);
  EXPECT_EQ(scene.recorded->tolerance, 8);
  ASSERT_TRUE(scene.stage);
  const scene::StageRecord& record = *scene.stage;
  EXPECT_EQ(record.stage, "coplanar");
  EXPECT_EQ(record.work_tolerance, 33.5);
  EXPECT_EQ(record.planes[0].slits, (std::vector<std::array<scene::VertexId, 2>>{{0, 2}}));
  EXPECT_EQ(record.faces[0].surface_rank, 3u);
  EXPECT_EQ(record.faces[0].triangles.size(), 2u);
  EXPECT_EQ(record.faces[0].sources.size(), 2u);
  EXPECT_EQ(record.face_of, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(record.ledger[0].rules, std::vector<std::string>{"RL302"});
}

TEST(Stage, WithoutPlanesKeepsVerticesAsTheyCameIn) {
  json stage = square();
  stage["planes"] = stage["points"] = json::array();
  stage["vertices"] = {{0.1, 0, 0}, {1, 0, 0}, {1, 1.3, 0}, {0, 1, 0}};
  const ReadResult result = read(stage);
  EXPECT_EQ(tests::issue_text(result), "");
  EXPECT_EQ(result.scene.vertices[0].x, 0.1);
  EXPECT_THAT(tests::outer_loop(result.scene, 0), ElementsAre(0, 1, 2, 3));
}

TEST(Stage, IsKnownByItsContent) {
  EXPECT_EQ(tests::read_text(square().dump(), "model.json").scene.format, "stage");
  EXPECT_NE(find_reader("{\"asset\": {\"version\": \"2.0\"}}", "a.gltf")->format, "stage");
}

TEST(Stage, RefusesWhatIsNone) {
  const auto refused = [](const std::string& text) {
    const ReadResult result = tests::read_text(text, "model.stage.json");
    EXPECT_TRUE(result.scene.faces.empty()) << text;
    return tests::issue_text(result);
  };
  EXPECT_THAT(refused("{"), HasSubstr("byte 1: not well-formed JSON"));
  EXPECT_THAT(refused("[1]"), HasSubstr("this is not a stage file"));
  EXPECT_THAT(refused("{\"format\": \"other\"}"), HasSubstr("this is not a stage file"));
  json newer = square();
  newer["version"] = 2;
  EXPECT_THAT(refused(newer.dump()), HasSubstr("only version 1"));
  json placeless = square();
  placeless.erase("lattice");
  EXPECT_THAT(refused(placeless.dump()), HasSubstr("without its lattice"));
}

// Each of these makes the planes of no use; the faces stay what they are.
TEST(Stage, LeavesOutPlanesThatDoNotFit) {
  const std::vector<std::pair<std::string, json>> spoilt{
      {"/planes/0/normal", {0, 0, 2}},
      {"/planes/0/normal", {0, 0.6, 0.8}},
      {"/planes/0/offset", 5000},
      {"/planes/0/area", -1},
      {"/planes/0/slits", {{0, 9}}},
      {"/planes/0/slits", {{1, 1}}},
      {"/planes/0/points", {17}},
      {"/points/3", {0, 0, 0}},
      {"/workTolerance", 1e9},
      {"/faces/0/plane", 4},
      {"/faces/0/along", "yes"},
      {"/faces/0/along", false},
      {"/faces/0/triangles", json::array()},
      {"/faces/0/triangles", {{0, 2, 1}}},
      {"/faces/0/triangles", {{0, 1, 8}}},
      {"/faces/0/triangles", {{0, 1, 2}, {0, 1, 3}}},
  };
  for (const auto& [pointer, value] : spoilt) {
    SCOPED_TRACE(pointer + " " + value.dump());
    json stage = square();
    stage[json::json_pointer(pointer)] = value;
    const ReadResult result = read(stage);
    EXPECT_THAT(tests::issue_text(result), HasSubstr("the planes do not fit the faces"));
    EXPECT_TRUE(result.scene.stage->planes.empty());
    EXPECT_EQ(result.scene.faces.size(), 1u);
    EXPECT_EQ(result.scene.loops[0].count, 4u);
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
  }
}

TEST(Stage, LeavesOutFacesOfPointsThatAreNotThere) {
  json stage = square();
  stage["faces"][0]["loops"] = {{0, 1, 4}};
  const ReadResult result = read(stage);
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::IndexOutOfRange), 1u);
  EXPECT_TRUE(result.scene.faces.empty());
}

TEST(Stage, KeepsThePlaceOfAPointThatCannotBeRead) {
  for (const json& point :
       {json({0, 0}), json({0, 0, 0.5}), json({0, 0, 8388608}), json({0, 0, -8388608}), json("x")}) {
    json stage = square();
    stage["points"][3] = point;
    const ReadResult result = read(stage);
    EXPECT_THAT(tests::issue_text(result), HasSubstr("a point is not three whole numbers"));
    EXPECT_TRUE(std::isnan(result.scene.vertices[3].x));
    EXPECT_EQ(result.scene.vertices[2], geom::dvec3(1001, 1000, 0));
  }
}

// Any member of any other type: an issue at most, never a crash.
TEST(Stage, StandsMembersOfAnyType) {
  const json whole = square();
  std::vector<json::json_pointer> places;
  const std::function<void(const json&, const json::json_pointer&)> gather = [&](const json& value,
                                                                                 const json::json_pointer& at) {
    places.push_back(at);
    if (value.is_object()) {
      for (const auto& [key, member] : value.items()) gather(member, at / key);
    } else if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) gather(value[i], at / i);
    }
  };
  gather(whole, json::json_pointer());
  for (const auto& place : places) {
    for (const json& value :
         {json(nullptr), json(-1), json(1e300), json("x"), json::array(), json::object(), json(true)}) {
      json stage = whole;
      stage[place] = value;
      EXPECT_EQ(tests::broken_invariant(read(stage).scene), "") << place << ' ' << value;
    }
  }
}

TEST(Stage, StandsBeingCutAtEveryByte) {
  const std::string text = square().dump();
  for (std::size_t length = 0; length < text.size(); ++length) {
    const ReadResult result = tests::read_text(text.substr(0, length), "model.stage.json");
    EXPECT_FALSE(result.issues.all().empty()) << length;
    EXPECT_TRUE(result.scene.faces.empty()) << length;
  }
}

TEST(Stage, KeepsToItsLimits) {
  Limits limits;
  limits.vertices = 3;
  const ReadResult result = tests::read_text(square().dump(), "model.stage.json", "no-such-folder", limits);
  EXPECT_THAT(tests::issue_text(result), HasSubstr("the limit of 3 vertices is reached"));
  EXPECT_TRUE(result.scene.vertices.empty());
}

}  // namespace
}  // namespace rad::readers
