#include "solve/receivers.h"

#include <gtest/gtest.h>

#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

TEST(Receivers, NodesMoveIntoTheirSectorAndOffTheSurface) {
  tests::GridMesh grid(2);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2, 1, 0);
  const auto receivers = receivers_of(grid.mesh);
  ASSERT_EQ(receivers.size(), 9u + 4u);
  const double lift = lift_of(grid.mesh), inward = 1e-3 * 0.5;
  EXPECT_GE(lift, 2 * grid.mesh.pitch);
  EXPECT_LT(lift, grid.mesh.tolerance);
  EXPECT_NEAR(glm::length(receivers[0].position - dvec3(0, 0, lift)), inward, 1e-12);
  EXPECT_NEAR(receivers[0].position.x, receivers[0].position.y, 1e-12);
  EXPECT_NEAR(receivers[1].position.y, inward, 1e-12);
  EXPECT_EQ(receivers[1].position.x, 0.5);
  EXPECT_EQ(receivers[4].position, dvec3(0.5, 0.5, lift));
  EXPECT_NEAR(glm::length(receivers[centre_of(grid.mesh, 0)].position - dvec3(0.25, 0.25, lift)), 0, 1e-12);
}

TEST(Receivers, FourTolerancesInwardAndNeverMoreThanAQuarterOfTheElement) {
  tests::GridMesh grid(2);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2, 1, 0);
  grid.mesh.tolerance = 0.01;
  EXPECT_NEAR(receivers_of(grid.mesh)[1].position.y, 0.04, 1e-12);
  grid.mesh.tolerance = 0.1;
  EXPECT_NEAR(receivers_of(grid.mesh)[1].position.y, 0.125, 1e-12);
}

}  // namespace
}  // namespace rad::solve
