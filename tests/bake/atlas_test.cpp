#include "bake/atlas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mapped_scenes.h"

namespace rad::bake {
namespace {

using testing::HasSubstr;

// Squares of one patch each, apart from each other, with sides from 1 on.
MappedScene squares(int count) {
  MappedScene scene;
  double x = 0;
  for (int i = 0; i < count; ++i) {
    const double side = 1 + 0.1 * i;
    std::vector<mesh::NodeId> nodes;
    for (const dvec3& corner : {dvec3(x, 0, 0), dvec3(x + side, 0, 0), dvec3(x, side, 0), dvec3(x + side, side, 0)}) {
      nodes.push_back(scene.add_node(corner, 1 + i));
    }
    scene.add_patch(nodes, 2);
    x += 2 * side;
  }
  return scene;
}

void expect_sound(const Atlas& atlas) {
  for (std::size_t i = 0; i < atlas.places.size(); ++i) {
    const ChartPlace& a = atlas.places[i];
    EXPECT_LE(a.x + a.columns, atlas.pages[a.page].width);
    EXPECT_LE(a.y + a.rows, atlas.pages[a.page].height);
    for (std::size_t j = i + 1; j < atlas.places.size(); ++j) {
      const ChartPlace& b = atlas.places[j];
      EXPECT_TRUE(a.page != b.page || a.x + a.columns <= b.x || b.x + b.columns <= a.x || a.y + a.rows <= b.y ||
                  b.y + b.rows <= a.y)
          << i << " over " << j;
    }
  }
}

TEST(Atlas, OnePage_IsAsSmallAsItCanBe_AndNothingOverlaps) {
  const Atlas atlas = lay_out_atlas(squares(30).mesh, {.texel = 0.1});
  ASSERT_EQ(atlas.problem, "");
  ASSERT_EQ(atlas.pages.size(), 1u);
  EXPECT_LE(atlas.pages[0].width, 256u);
  expect_sound(atlas);
}

TEST(Atlas, TexelsAreNoLongerThanAsked_AndSidesRunThroughCentres) {
  const MappedScene scene = squares(5);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.3});
  for (std::size_t i = 0; i < atlas.places.size(); ++i) {
    const ChartPlace& place = atlas.places[i];
    EXPECT_LE(std::max(place.texel.x, place.texel.y), 0.3 * (1 + kTexelRounding));
    const dvec2 end = place.to_texels({atlas.charts[i].width, atlas.charts[i].height});
    EXPECT_DOUBLE_EQ(end.x, std::round(end.x));
    EXPECT_DOUBLE_EQ(end.y, std::round(end.y));
    EXPECT_EQ(place.columns, static_cast<std::uint32_t>(end.x) + 1 + kGutter);
  }
}

// 1.2 is four texels of 0.3, also as the nearest double and as the nearest float of a file.
TEST(Atlas, SideOfWholeTexelsButForRounding_HasThatMany) {
  for (const double side : {1.2, 4 * 0.3, static_cast<double>(1.2f), 1.2 * (1 + 0x1p-52)}) {
    MappedScene scene;
    std::vector<mesh::NodeId> nodes;
    for (const dvec3& at : {dvec3(0, 0, 0), dvec3(side, 0, 0), dvec3(0, side, 0), dvec3(side, side, 0)}) {
      nodes.push_back(scene.add_node(at, 1));
    }
    scene.add_patch(nodes, 2);
    const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.3});
    EXPECT_EQ(atlas.places[0].columns, 4 + 1 + 2 * kGutter);
    EXPECT_EQ(atlas.places[0].rows, 4 + 1 + 2 * kGutter);
  }
}

TEST(Atlas, MoreThanAPageHolds_GoesOnToFurtherPages) {
  const Atlas atlas = lay_out_atlas(squares(40).mesh, {.texel = 0.05, .page_size = 128});
  ASSERT_EQ(atlas.problem, "");
  EXPECT_GT(atlas.pages.size(), 2u);
  expect_sound(atlas);
}

// "… texels of 0.12 fit": what the message says.
double named_texel(const std::string& problem) {
  const std::size_t from = problem.rfind("texels of ") + 10;
  return std::stod(problem.substr(from));
}

TEST(Atlas, ChartLargerThanAPage_NamesTheTexelThatFits) {
  const MappedScene scene = squares(20);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.001, .page_size = 256});
  EXPECT_THAT(atlas.problem, HasSubstr("texels of 0.001 do not fit"));
  EXPECT_TRUE(atlas.pages.empty());
  const double texel = named_texel(atlas.problem);
  EXPECT_LT(texel, 0.02);
  EXPECT_EQ(lay_out_atlas(scene.mesh, {.texel = texel, .page_size = 256}).problem, "");
}

TEST(Atlas, MoreTexelsThanAllowed_NamesTheTexelThatFits) {
  const MappedScene scene = squares(50);
  const AtlasOptions options{.texel = 0.02, .page_size = 256, .most_texels = 4 * 256 * 256};
  const Atlas atlas = lay_out_atlas(scene.mesh, options);
  ASSERT_THAT(atlas.problem, HasSubstr("fit"));
  AtlasOptions wider = options;
  wider.texel = named_texel(atlas.problem);
  const Atlas fitting = lay_out_atlas(scene.mesh, wider);
  EXPECT_EQ(fitting.problem, "");
  EXPECT_LE(fitting.pages.size(), 4u);
}

TEST(Atlas, MoreFacesThanGuttersAllow_SaysSo) {
  const Atlas atlas = lay_out_atlas(squares(50).mesh, {.texel = 1, .page_size = 64, .most_texels = 1000});
  EXPECT_THAT(atlas.problem, HasSubstr("whatever the size of a texel"));
}

TEST(Atlas, TexelThatNobodyAskedFor_GrowsUntilItFits) {
  const Atlas atlas = lay_out_atlas(squares(10).mesh, {.finest_texel = 1e-6});
  EXPECT_EQ(atlas.problem, "");
  EXPECT_GT(atlas.texel, 1e-6);
}

// A wall ends in the middle of a floor of 4 × 4 patches: nodes are double along it.
TEST(LightCharts, WallThatEndsInAFloor_CutsTheFloor) {
  MappedScene scene;
  std::vector<mesh::NodeId> nodes;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 4; ++i) nodes.push_back(scene.add_node({i, j, 0}, 1));
  }
  const mesh::NodeId other[] = {scene.add_node({2, 0, 0}, 5), scene.add_node({2, 1, 0}, 5)};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = [&](std::size_t a, std::size_t b) {
        return i >= 2 && a == 2 && b < 2 ? other[b] : nodes[b * 5 + a];
      };
      scene.add_patch({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}, 2);
    }
  }
  const std::vector<LightChart> charts = light_charts(scene.mesh);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].patches, (std::vector<PatchId>{0, 1, 4, 5, 8, 9, 12, 13}));
}

TEST(LightCharts, OtherMaterialOrPlane_IsAnotherChart) {
  EXPECT_EQ(light_charts(cone(6, 2).mesh).size(), 6u);
  MappedScene scene;
  std::vector<mesh::NodeId> nodes;
  for (int j = 0; j <= 1; ++j) {
    for (int i = 0; i <= 2; ++i) nodes.push_back(scene.add_node({i, j, 0}, 1));
  }
  scene.add_patch({nodes[0], nodes[1], nodes[3], nodes[4]}, 2, 0);
  scene.add_patch({nodes[1], nodes[2], nodes[4], nodes[5]}, 2, 1);
  EXPECT_EQ(light_charts(scene.mesh).size(), 2u);
}

TEST(LightCharts, SeenFromTheFront_RightAndDownAreWhatTheySay) {
  const MappedScene scene = cone(5, 2);
  for (const LightChart& chart : light_charts(scene.mesh)) {
    const dvec3& normal = scene.mesh.patches[chart.patches.front()].normal;
    EXPECT_NEAR(glm::length(glm::cross(chart.right, normal) - chart.down), 0, 1e-12);
    EXPECT_GE(chart.width, chart.height);
  }
}

}  // namespace
}  // namespace rad::bake
