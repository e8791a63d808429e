#include "solve/far_radiator.h"

#include <gtest/gtest.h>

#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

/// A unit square that looks down from height 1, a grid of receivers below, and maybe something in between.
struct Scene {
  tests::GridMesh grid{8};
  std::vector<Receiver> receivers;
  Radiators radiators;
  PatchSamples samples;
  std::unique_ptr<Visibility> visibility;
  Importance importance;

  explicit Scene(double hidden_until) {
    grid.add_rectangle({-0.5, -0.5, 1}, {0, 1, 0}, {1, 0, 0}, 1, 1, 4, 0);
    grid.add_rectangle({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 1, 1, 128, 0);
    if (hidden_until > -3) grid.add_rectangle({-3, -3, 0.9}, {hidden_until + 3, 0, 0}, {0, 6, 0}, 1, 1, 1, 0);
    receivers = receivers_of(grid.mesh);
    radiators = radiators_of(grid.mesh, receivers);
    samples = patch_samples(grid.mesh, radiators);
    visibility = std::make_unique<Visibility>(grid.mesh);
    importance.noise = 1e-3;
  }

  /// Of the square, at the nodes of the grid below.
  std::vector<FarView> views(double share_of_factor, std::vector<ReceiverId>& nodes) {
    const CouplingSource source{grid.mesh, radiators, receivers, samples, *visibility, importance, lift_of(grid.mesh)};
    std::vector<FarRequest> requests;
    for (mesh::NodeId node = 0; node < grid.mesh.nodes.size(); ++node) {
      if (grid.mesh.nodes[node].position.z > 0) continue;
      nodes.push_back(node);
      requests.push_back({node, share_of_factor});
    }
    std::vector<FarView> views;
    FarRadiator(source, 0).look(requests, views);
    return views;
  }

  [[nodiscard]] double factor(ReceiverId receiver, double from) const {
    const std::vector<dvec3> seen{{from, -0.5, 1}, {from, 0.5, 1}, {0.5, 0.5, 1}, {0.5, -0.5, 1}};
    return form_factor(above_horizon(seen, receivers[receiver]), receivers[receiver].normal);
  }
};

TEST(FarRadiator, WithNothingInTheWayIsTheFormFactor) {
  Scene scene(-3);
  std::vector<ReceiverId> nodes;
  const std::vector<FarView> views = scene.views(1e-4, nodes);
  ASSERT_EQ(views.size(), nodes.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(views[i].seen, Seen::Whole);
    EXPECT_NEAR(views[i].weight[0], scene.factor(nodes[i], -0.5), 1e-6);
  }
}

/// However few the rays, on the mean over many receivers no light is lost and none is won.
TEST(FarRadiator, FewRaysAreNotBiased) {
  for (const double edge : {-0.2, 0.3}) {
    Scene scene(edge);
    std::vector<ReceiverId> nodes;
    const std::vector<FarView> views = scene.views(1e-4, nodes);
    double few = 0, exact = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_TRUE(views[i].seen == Seen::Whole || views[i].seen == Seen::Blocked) << "one ray";
      few += views[i].weight[0];
    }
    nodes.clear();
    for (const FarView& view : scene.views(1e6, nodes)) exact += view.weight[0];
    EXPECT_NEAR(few / exact, 1, 0.1) << edge;  // three standard errors
  }
}

}  // namespace
}  // namespace rad::solve
