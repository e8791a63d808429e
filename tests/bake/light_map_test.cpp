#include "bake/light_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bake/png.h"
#include "bake/srgb_codes.h"
#include "mapped_scenes.h"

namespace rad::bake {
namespace {

TEST(SrgbCodes, OfEveryFloatTried_IsTheCodeOfItsDouble) {
  const SrgbCodes codes;
  for (float value = -0.1f; value < 1.2f; value += 1.7e-5f) ASSERT_EQ(codes.of(value), srgb_code(value)) << value;
  EXPECT_EQ(codes.of(0), 0);
  EXPECT_EQ(codes.of(1), 255);
}

TEST(LightMapBaker, EmissiveWhite_IsTheBrightestOfEachMaterial) {
  const MappedScene scene = cone(5, 4);
  const std::vector<scene::Material> materials(1);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.1});
  const LightMapBaker baker(atlas, scene.mesh, materials, scene.field,
                            {.look = scene::LightMapLook::Emissive, .exposure = 0.5, .software = ""});
  double brightest = 0;
  for (const dvec3& radiosity : scene.field.radiosity) brightest = std::max(brightest, radiosity.x);
  ASSERT_EQ(baker.white().size(), atlas.charts.size());
  for (const double white : baker.white()) EXPECT_DOUBLE_EQ(white, brightest);
  EXPECT_LT(baker.bake(0).clamped_area, 0.01 * baker.bake(0).area);
}

// A square for each radiosity, all of one material.
MappedScene squares_of(const std::vector<double>& radiosities) {
  MappedScene scene;
  for (std::size_t i = 0; i < radiosities.size(); ++i) {
    const double x = 2 * static_cast<double>(i);
    std::vector<mesh::NodeId> nodes;
    for (const dvec3& at : {dvec3(x, 0, 0), dvec3(x + 1, 0, 0), dvec3(x, 1, 0), dvec3(x + 1, 1, 0)}) {
      nodes.push_back(scene.add_node(at, radiosities[i]));
    }
    scene.add_patch(nodes, 2);
  }
  return scene;
}

TEST(LightMapBaker, EmissiveWhite_OfDarkCharts_IsStepsBelow) {
  const MappedScene scene = squares_of({1024, 129, 128, 1, 1e-6});
  const std::vector<scene::Material> materials(1);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.1});
  const LightMapBaker baker(atlas, scene.mesh, materials, scene.field,
                            {.look = scene::LightMapLook::Emissive, .exposure = 0.5, .software = ""});
  EXPECT_EQ(baker.white(), (std::vector<double>{1024, 1024, 128, 2, 2}));
  EXPECT_EQ(baker.bake(0).clamped_area, 0);
}

TEST(LightMapBaker, UnlitWhite_IsOneOverTheExposure_AndWhatIsBrighterCounts) {
  MappedScene scene;
  for (const double value : {1.0, 3.0}) {
    std::vector<mesh::NodeId> nodes;
    for (const dvec3& at : {dvec3(value, 0, 0), dvec3(value + 1, 0, 0), dvec3(value, 1, 0), dvec3(value + 1, 1, 0)}) {
      nodes.push_back(scene.add_node(at, value));
    }
    scene.add_patch(nodes, 2);
  }
  const std::vector<scene::Material> materials(1);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.1});
  const LightMapBaker baker(atlas, scene.mesh, materials, scene.field, {.exposure = 0.5, .software = ""});
  EXPECT_EQ(baker.white(), (std::vector<double>{2, 2}));
  const BakedPage page = baker.bake(0);
  EXPECT_NEAR(page.area, 2, 1e-5);
  EXPECT_NEAR(page.clamped_area, 1, 1e-5);
}

TEST(LightMapBaker, DarkScene_IsBakedToo) {
  MappedScene scene;
  std::vector<mesh::NodeId> nodes;
  for (const dvec3& at : {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(1, 1, 0)}) {
    nodes.push_back(scene.add_node(at, 0));
  }
  scene.add_patch(nodes, 2);
  const std::vector<scene::Material> materials(1);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.1});
  for (const auto look : {scene::LightMapLook::Unlit, scene::LightMapLook::Emissive}) {
    for (const auto stored : {StoredQuantity::Exitance, StoredQuantity::Irradiance}) {
      const LightMapBaker baker(atlas, scene.mesh, materials, scene.field,
                                {.look = look, .stored = stored, .exposure = 1, .software = ""});
      const BakedPage page = baker.bake(0);
      EXPECT_EQ(baker.precision(), ExrPrecision::Half);
      EXPECT_FALSE(page.exr.empty());
      EXPECT_FALSE(page.png.empty());
      EXPECT_EQ(page.clamped_area, 0);
      EXPECT_EQ(baker.white()[0], 1);
    }
  }
}

TEST(LightMapPlaces, CoordinatesLieOnThePage_InsideTheGutter) {
  const MappedScene scene = cone(5, 2);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.2});
  const geom::Lattice lattice{0x1p-20, {0, 0, 0}};
  mesh::DisplayMesh display;
  for (const mesh::Node& node : scene.mesh.nodes) {
    const dvec3 at = node.position / lattice.pitch;
    display.vertices.push_back(
        {.point = {static_cast<std::int32_t>(std::lround(at.x)), static_cast<std::int32_t>(std::lround(at.y)),
                   static_cast<std::int32_t>(std::lround(at.z))},
         .node = {},
         .share = 0});
  }
  for (const mesh::Element& element : scene.mesh.elements) {
    display.faces.push_back({.corner = element.corners.node, .count = 4, .patch = element.patch});
  }
  const scene::LightMap map = light_map_places(atlas, display, lattice, std::vector<double>(atlas.charts.size(), 2));
  ASSERT_EQ(map.coordinates.size(), 4 * display.faces.size());
  ASSERT_EQ(map.page_of_face.size(), display.faces.size());
  EXPECT_EQ(map.white_luminance, std::vector<double>(display.faces.size(), 2 / std::numbers::pi));
  for (std::size_t i = 0; i < map.coordinates.size(); ++i) {
    const ChartPlace& place = atlas.places[atlas.chart_of_patch[display.faces[i / 4].patch]];
    const dvec2 texel = map.coordinates[i] * dvec2(atlas.pages[0].width, atlas.pages[0].height) - 0.5;
    EXPECT_GE(texel.x, place.x + kGutter - 1e-3);
    EXPECT_LE(texel.x, place.x + place.columns - 1 - kGutter + 1e-3);
    EXPECT_GE(texel.y, place.y + kGutter - 1e-3);
    EXPECT_LE(texel.y, place.y + place.rows - 1 - kGutter + 1e-3);
  }
}

}  // namespace
}  // namespace rad::bake
