// What radfix records in the extras of a glTF document, and what hostile extras do not do.
#include <gtest/gtest.h>

#include "tests/readers/gltf_document.h"
#include "tests/readers/read_text.h"

namespace rad::readers {
namespace {

using tests::GltfDocument;
using tests::Json;

GltfDocument triangle() {
  GltfDocument document;
  const std::size_t positions = document.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  document.add_mesh({{"attributes", {{"POSITION", positions}}}, {"material", 0}});
  document.json["materials"] = Json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}});
  return document;
}

scene::Scene scene_of(const GltfDocument& document) {
  ReadResult result = tests::read_text(document.text(), "model.gltf");
  EXPECT_EQ(tests::issue_text(result), "");
  EXPECT_EQ(result.scene.faces.size(), 1u);
  return std::move(result.scene);
}

TEST(GltfRecord, HoldsToleranceAndLattice) {
  GltfDocument document = triangle();
  document.json["asset"]["extras"]["radfix"] = {{"tolerance", 0.5}, {"pitch", 0.25}, {"origin", {1, 2, 3.5}}};
  const auto recorded = scene_of(document).recorded;
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->tolerance, 0.5);
  EXPECT_EQ(recorded->lattice.pitch, 0.25);
  EXPECT_EQ(recorded->lattice.origin, geom::dvec3(1, 2, 3.5));
}

TEST(GltfRecord, HoldsTheMaterialBehindAnUnlitColour) {
  GltfDocument document = triangle();
  document.json["materials"][0]["extras"]["radfix"] = {{"reflectance", {0.25, 0.5, 0.75}}, {"exitance", {9, 0, 0}}};
  const scene::Material material = scene_of(document).materials.at(1);
  EXPECT_EQ(material.reflectance, geom::dvec3(0.25, 0.5, 0.75));
  EXPECT_TRUE(material.reflectance_stated);
  EXPECT_EQ(material.emission, geom::dvec3(9, 0, 0));
  EXPECT_EQ(material.emission_unit, scene::Material::EmissionUnit::Exitance);
  document.json["materials"][0]["extras"]["radfix"]["stated"] = false;
  EXPECT_FALSE(scene_of(document).materials.at(1).reflectance_stated);
}

TEST(GltfRecord, IsPassedOverInSilenceWhereItIsAnythingElse) {
  const Json sound = {{"tolerance", 0.5}, {"pitch", 0.25}, {"origin", {1, 2, 3}}};
  std::vector<Json> others = {Json(), 1, "text", Json::array({1, 2}), Json::object()};
  for (const char* key : {"tolerance", "pitch", "origin"}) {
    for (const Json& value : {Json(), Json("1"), Json(true), Json::array({1, 2}), Json::array({1, 2, "3"})}) {
      others.push_back(sound);
      others.back()[key] = value;
    }
  }
  for (const Json& other : others) {
    GltfDocument document = triangle();
    document.json["asset"]["extras"]["radfix"] = other;
    document.json["materials"][0]["extras"]["radfix"] = other;
    const scene::Scene scene = scene_of(document);
    EXPECT_FALSE(scene.recorded) << other;
    EXPECT_EQ(scene.materials.at(1).reflectance, geom::dvec3(1, 1, 1)) << other;
    document.json["asset"]["extras"] = other;
    document.json["materials"][0]["extras"] = other;
    EXPECT_FALSE(scene_of(document).recorded);
  }
}

// Where formats name no objects fewer faces have to agree (1b): a name made up here would ask more of the result.
TEST(GltfRecord, WhatRadfixWroteWithoutANameHasNone) {
  GltfDocument document = triangle();
  document.json["nodes"] = Json::array({{{"mesh", 0}}});
  document.json["meshes"][0]["name"] = "group";
  EXPECT_EQ(scene_of(document).objects.back(), "group");
  document.json["asset"]["extras"]["radfix"] = {{"tolerance", 0.5}, {"pitch", 0.25}, {"origin", {0, 0, 0}}};
  const scene::Scene scene = scene_of(document);
  ASSERT_TRUE(scene.recorded);
  EXPECT_EQ(scene.objects, std::vector<std::string>{""});
}

TEST(GltfRecord, PrimitivesThatNameOnePositionAccessorShareItsVertices) {
  GltfDocument document = triangle();
  Json& primitives = document.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  EXPECT_EQ(tests::read_text(document.text(), "model.gltf").scene.vertices.size(), 3u);
  primitives[1]["attributes"]["POSITION"] = document.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_EQ(tests::read_text(document.text(), "model.gltf").scene.vertices.size(), 6u);
  document.json["nodes"] = Json::array({{{"mesh", 0}}, {{"mesh", 0}}});
  EXPECT_EQ(tests::read_text(document.text(), "model.gltf").scene.vertices.size(), 12u) << "each node its own";
}

}  // namespace
}  // namespace rad::readers
