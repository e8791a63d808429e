#include "bake/light_page.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "mapped_scenes.h"

namespace rad::bake {
namespace {

// The largest relative difference between what both charts at the slanting edges of a cone show along them.
double worst_seam(const MappedScene& scene, const Atlas& atlas, const std::vector<LightPage>& pages) {
  double worst = 0;
  const auto count = static_cast<std::uint32_t>(scene.mesh.patches.size());
  for (std::uint32_t patch = 0; patch < count; ++patch) {
    const mesh::Corners& corners = scene.mesh.patches[patch].corners;
    const dvec3 &from = scene.mesh.nodes[corners.node[1]].position, &to = scene.mesh.nodes[corners.node[2]].position;
    const std::uint32_t left = atlas.chart_of_patch[patch], right = atlas.chart_of_patch[(patch + 1) % count];
    for (int step = 0; step <= 1000; ++step) {
      const dvec3 at = from + (to - from) * (step / 1000.0);
      const dvec3 a = seen(atlas, pages, left, at), b = seen(atlas, pages, right, at);
      worst = std::max(worst, 2 * std::abs(a.x - b.x) / (a.x + b.x));
    }
  }
  return worst;
}

TEST(LightPage, ChartsThatShareNodes_ShowTheSameAlongTheirEdge) {
  const MappedScene scene = cone(7, 12);
  for (const double texel : {0.15, 0.11, 0.06, 0.031}) {
    const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = texel});
    ASSERT_EQ(atlas.problem, "");
    ASSERT_EQ(atlas.charts.size(), 7u);
    EXPECT_LT(worst_seam(scene, atlas, painted(atlas, scene)), 0.01) << "texel " << texel;
  }
}

TEST(LightPage, Integral_IsThatOfTheNodes) {
  const MappedScene scene = cone(7, 12);
  for (const double texel : {0.2, 0.15, 0.11, 0.06, 0.031}) {
    const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = texel});
    const dvec3 nodes = integral_over_nodes(scene), map = integral_over_map(atlas, painted(atlas, scene));
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(map[channel], nodes[channel], 0.005 * nodes[channel]) << "texel " << texel;
    }
  }
}

TEST(LightPage, InsideAChart_ItShowsWhatTheNodesSay) {
  const MappedScene scene = cone(5, 8);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.02});
  const std::vector<LightPage> pages = painted(atlas, scene);
  for (const mesh::Element& element : scene.mesh.elements) {
    dvec3 middle(0), value(0);
    for (const mesh::NodeId node : element.corners.all()) {
      middle += scene.mesh.nodes[node].position / 4.0;
      value += scene.field.radiosity[node] / 4.0;
    }
    const dvec3 shown = seen(atlas, pages, atlas.chart_of_patch[element.patch], middle);
    EXPECT_NEAR(shown.x, value.x, 0.01 * value.x);
  }
}

TEST(LightPage, AnyNumberOfThreads_GivesTheSameBits) {
  const MappedScene scene = cone(7, 12);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.01});
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return paint_page(atlas, 0, scene.mesh, scene.field);
  };
  const LightPage one = with(1), two = with(2);
  EXPECT_EQ(one.radiosity, two.radiosity);
  EXPECT_EQ(one.coverage, two.coverage);
}

// A floor with a wall on it: nodes of both sides at the same places, one side bright and the other dark.
TEST(LightPage, AcrossAWall_NoLightLeaks) {
  MappedScene scene;
  for (const double side : {0.0, 1.0}) {
    std::vector<mesh::NodeId> nodes;
    for (int j = 0; j <= 4; ++j) {
      for (int i = 0; i <= 4; ++i) nodes.push_back(scene.add_node({side + i / 4.0, j / 4.0, 0}, side == 0 ? 100 : 0));
    }
    scene.add_patch(nodes, 5);
  }
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.13});
  ASSERT_EQ(atlas.charts.size(), 2u);
  const std::vector<LightPage> pages = painted(atlas, scene);
  for (int step = 0; step <= 100; ++step) {
    EXPECT_NEAR(seen(atlas, pages, 0, {1, step / 100.0, 0}).x, 100, 1e-4);
    EXPECT_EQ(seen(atlas, pages, 1, {1, step / 100.0, 0}).x, 0);
  }
}

TEST(LightPage, ThinStrip_IsFilledByItsBorder) {
  MappedScene scene;
  std::vector<mesh::NodeId> nodes;
  for (int j = 0; j <= 1; ++j) {
    for (int i = 0; i <= 10; ++i) nodes.push_back(scene.add_node({i, j * 1e-3, 0}, 10 + i));
  }
  scene.add_patch(nodes, 11);
  const Atlas atlas = lay_out_atlas(scene.mesh, {.texel = 0.5});
  const std::vector<LightPage> pages = painted(atlas, scene);
  EXPECT_NEAR(seen(atlas, pages, 0, {2.5, 5e-4, 0}).x, 12.5, 1e-4);
  EXPECT_NEAR(integral_over_map(atlas, pages).x, integral_over_nodes(scene).x, 1e-6);
}

}  // namespace
}  // namespace rad::bake
