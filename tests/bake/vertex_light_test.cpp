#include "bake/vertex_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace rad::bake {
namespace {

using geom::dvec3;
using mesh::DisplayMesh;
using mesh::RadiosityField;
using mesh::RadiosityMesh;

dvec3 grey(double value) { return {value, value, value}; }

/// A row of separate right triangles of the given areas, one patch and three nodes of one radiosity each.
struct Row {
  RadiosityMesh mesh;
  RadiosityField field;
  DisplayMesh display;
  std::vector<scene::Material> materials{scene::Material{}, scene::Material{}};

  Row() { materials[1].emission = grey(100); }

  void add(double area, const dvec3& radiosity, scene::MaterialId material = 0) {
    const auto first = static_cast<mesh::NodeId>(mesh.nodes.size());
    const double x = static_cast<double>(mesh.patches.size()) * 1000;
    for (const dvec3& corner : {dvec3{x, 0, 0}, dvec3{x + 2 * area, 0, 0}, dvec3{x, 1, 0}}) {
      mesh.nodes.push_back({.position = corner, .normal = {0, 0, 1}, .inward = {0, 0, 0}});
      field.radiosity.push_back(radiosity);
      const auto node = static_cast<mesh::NodeId>(mesh.nodes.size() - 1);
      display.vertices.push_back({.point = {}, .node = {node, node}, .share = 0});
    }
    const mesh::Corners corners{.node = {first, first + 1, first + 2, 0}, .count = 3};
    const auto patch = static_cast<mesh::PatchId>(mesh.patches.size());
    mesh.patches.push_back({.corners = corners, .material = material, .normal = {0, 0, 1}, .area = area});
    mesh.elements.push_back({.corners = corners, .patch = patch});
  }

  [[nodiscard]] double exposure() const { return automatic_exposure(mesh, materials, field); }
  [[nodiscard]] scene::VertexLight light(std::optional<double> given = {}) const {
    return vertex_light(display, mesh, materials, field, given);
  }
};

TEST(AutomaticExposure, BrightSpotAboveThePercentile_IsLeftOut) {
  Row row;
  row.add(98.5, grey(4));
  row.add(1.5, grey(40));
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 4);
}

TEST(AutomaticExposure, BrightSpotBelowThePercentile_Counts) {
  Row row;
  row.add(97.5, grey(4));
  row.add(2.5, grey(40));
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 40);
}

TEST(AutomaticExposure, WeightsByArea_NotByCount) {
  Row row;
  row.add(1000, grey(2));
  for (int i = 0; i < 50; ++i) row.add(0.01, grey(30));
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 2);
}

TEST(AutomaticExposure, Luminance_IsThatOfRec709) {
  Row row;
  row.add(1, {1, 10, 100});
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / (0.2126 + 7.152 + 7.22));
}

TEST(AutomaticExposure, Emitters_DoNotCount) {
  Row row;
  row.add(1, grey(5));
  row.add(1000, grey(100), 1);
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 5);
}

TEST(AutomaticExposure, OnlyEmitters_ExposedForThem) {
  Row row;
  row.add(1, grey(100), 1);
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 100);
}

TEST(AutomaticExposure, DarkSurroundings_ExposedForTheEmitters) {
  Row row;
  row.add(10, grey(0));
  row.add(1, grey(100), 1);
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 100);
}

TEST(AutomaticExposure, MostlyDark_ExposedForTheBrightestNode) {
  Row row;
  row.add(1000, grey(0));
  row.add(1, grey(3));
  row.add(1, grey(7));
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 7);
}

TEST(AutomaticExposure, AllDarkOrNothing_One) {
  Row row;
  EXPECT_EQ(row.exposure(), 1);
  row.add(1, grey(0));
  EXPECT_EQ(row.exposure(), 1);
}

TEST(AutomaticExposure, Quadrilateral_CountsWhole) {
  Row row;
  row.add(40, grey(1));
  row.mesh.nodes.push_back({.position = {80, 1, 0}, .normal = {0, 0, 1}, .inward = {0, 0, 0}});
  row.field.radiosity.push_back(grey(1));
  row.mesh.elements[0].corners = {.node = {0, 1, 3, 2}, .count = 4};
  row.add(1.7, grey(9));
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 9) << "1.7 of 81.7 is above 2 %";
  row.mesh.nodes[5].position.x = row.mesh.nodes[4].position.x + 3.2;
  EXPECT_DOUBLE_EQ(row.exposure(), 0.8 / 1)
      << "1.6 of 81.6 is below; of the 41.6 of half the quadrilateral it is above";
}

TEST(VertexLight, VertexBetweenTwoNodes_GetsItsShareOfBoth) {
  Row row;
  row.add(1, {0, 0, 0});
  row.field.radiosity[0] = {1, 2, 3};
  row.field.radiosity[1] = {5, 10, 7};
  row.display.vertices.push_back({.point = {}, .node = {0, 1}, .share = 0.25});
  const scene::VertexLight light = row.light(0.05);
  ASSERT_EQ(light.radiosity.size(), 4u);
  EXPECT_EQ(light.radiosity[3], dvec3(2, 4, 4));
  EXPECT_EQ(light.colour[3], 0.05 * dvec3(2, 4, 4));
  EXPECT_EQ(light.radiosity[0], dvec3(1, 2, 3));
}

TEST(VertexLight, Clamped_CountsVerticesWithAChannelAboveOne) {
  Row row;
  row.add(1, {0.5, 1, 0.5});
  row.add(1, {0, 0, 1.5});
  const scene::VertexLight light = row.light(1);
  EXPECT_EQ(light.clamped_share, 0.5);
  EXPECT_EQ(light.colour[0], dvec3(0.5, 1, 0.5));
  EXPECT_EQ(light.colour[3], dvec3(0, 0, 1));
  EXPECT_EQ(light.radiosity[3], dvec3(0, 0, 1.5));
}

TEST(VertexLight, ExposureGiven_IsUsedAndRecorded) {
  Row row;
  row.add(1, grey(4));
  EXPECT_EQ(row.light(0.125).exposure, 0.125);
  EXPECT_EQ(row.light(0.125).colour[0], grey(0.5));
  EXPECT_DOUBLE_EQ(row.light().exposure, 0.2);
}

RC_GTEST_PROP(VertexLight, AnyField_ColoursInRangeAndScaleFree, ()) {
  const auto levels = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000)));
  Row row, doubled;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double area = 1.0 + static_cast<double>(i % 7);
    row.add(area, grey(levels[i]));
    doubled.add(area, grey(2.0 * levels[i]));
  }
  const scene::VertexLight light = row.light(), twice = doubled.light();
  for (const dvec3& colour : light.colour) RC_ASSERT(colour.x >= 0 && colour.x <= 1);
  RC_ASSERT(light.colour == twice.colour);
  if (*std::max_element(levels.begin(), levels.end()) > 0) RC_ASSERT(light.exposure == 2 * twice.exposure);
}

}  // namespace
}  // namespace rad::bake
