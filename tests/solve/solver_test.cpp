#include "solve/solver.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>

#include "solve/form_factor.h"
#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

using tests::GridMesh;
using tests::material;

mesh::RadiosityField solved(const GridMesh& grid, const std::vector<scene::Material>& materials,
                            const SolveOptions& options = {}) {
  Progress progress;
  return solve(grid.mesh, materials, options, progress);
}

/// Area mean of the radiosity of one material over its elements (rectangles).
dvec3 mean_radiosity(const GridMesh& grid, const mesh::RadiosityField& field, scene::MaterialId wanted) {
  dvec3 sum(0);
  double count = 0;
  for (const mesh::Element& element : grid.mesh.elements) {
    if (grid.mesh.patches[element.patch].material != wanted) continue;
    for (const mesh::NodeId node : element.corners.all()) sum += field.radiosity[node];
    count += element.corners.count;
  }
  return sum / count;
}

/// Emitter of exitance 1 at height 1 over a receiver of reflectance `rho`, both unit squares.
GridMesh parallel_squares(int patches, int split) {
  GridMesh grid(std::sqrt(3.0));
  grid.add_rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, patches, patches, split, 0);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, patches, patches, split, 1);
  return grid;
}

const std::vector<scene::Material> kLightAndBlack{material(dvec3(0), dvec3(1, 2, 4)), material(dvec3(0))};
const std::vector<scene::Material> kLightAndGrey{material(dvec3(0), dvec3(1, 2, 4)), material(dvec3(0.5))};

TEST(Solver, ParallelSquaresExchangeTheHandbooksFormFactor) {
  const auto field = solved(parallel_squares(4, 4), kLightAndBlack);
  // F between directly opposed unit squares at distance 1.
  EXPECT_NEAR(field.energy.received.x / field.energy.emitted.x, 0.199825, 2e-5);
  EXPECT_NEAR(field.energy.received.z / field.energy.emitted.z, 0.199825, 2e-5);
  EXPECT_TRUE(field.complete);
}

TEST(Solver, PerpendicularSquaresExchangeTheHandbooksFormFactor) {
  GridMesh grid(std::sqrt(3.0));
  grid.add_rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 8, 8, 4, 0);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 8, 4, 1);
  const auto field = solved(grid, kLightAndBlack);
  EXPECT_NEAR(field.energy.received.x / field.energy.emitted.x, 0.200044, 2e-4);
}

TEST(Solver, ReceiversGetTheSamePowerInEitherDirection) {
  // A small and a large square that do not face each other squarely: A₁ F₁₂ = A₂ F₂₁.
  GridMesh grid(6);
  grid.add_rectangle({0, 0, 2}, {0, 1, 0}, {1, 0, 0}, 4, 4, 2, 0);
  grid.add_rectangle({-1, -2, 0}, {3, 0, 0}, {0, 3, 0}, 8, 8, 2, 1);
  const auto down = solved(grid, {material(dvec3(0), dvec3(1)), material(dvec3(0))});
  const auto up = solved(grid, {material(dvec3(0)), material(dvec3(0), dvec3(1))});
  EXPECT_NEAR(down.energy.received.x / up.energy.received.x, 1, 5e-4);
}

TEST(Solver, FurnaceIsUniform) {
  GridMesh grid(2 * std::sqrt(3.0));
  grid.add_box({0, 0, 0}, {2, 2, 2}, true, 3, 2, 0);
  const auto field = solved(grid, {material({0.5, 0.9, 0.2}, {1, 2, 3})});
  for (const dvec3& radiosity : field.radiosity) {
    EXPECT_NEAR(radiosity.x, 2.0, 0.002 * 2);
    EXPECT_NEAR(radiosity.y, 20.0, 0.002 * 20);
    EXPECT_NEAR(radiosity.z, 3.75, 0.002 * 3.75);
  }
}

TEST(Solver, FurnaceOfTrianglesWithABoxInItIsUniform) {
  GridMesh grid(2 * std::sqrt(3.0));
  const std::array<dvec3, 4> corner{dvec3(0, 0, 0), dvec3(2, 0, 0), dvec3(0, 2, 0), dvec3(0, 0, 2)};
  for (const auto& face : {std::array{0, 1, 2}, std::array{0, 3, 1}, std::array{0, 2, 3}, std::array{1, 3, 2}}) {
    grid.add_triangle({corner[face[0]], corner[face[1]], corner[face[2]]}, 4, 2, 0);
  }
  grid.add_box({0.2, 0.3, 0.2}, {0.5, 0.6, 0.4}, false, 2, 2, 0);
  const auto field = solved(grid, {material(dvec3(0.5), dvec3(1))});
  double error = 0;
  for (const dvec3& radiosity : field.radiosity) error = std::max(error, std::abs(radiosity.x - 2));
  EXPECT_LT(error, 0.01 * 2);
  EXPECT_LT(std::abs(field.energy.escaped.x), 0.005 * field.energy.shot.x);
}

TEST(Solver, EnergyIsAccountedFor) {
  GridMesh grid(5);
  grid.add_box({0, 0, 0}, {3, 3, 2.5}, true, 4, 2, 1);
  grid.add_rectangle({1, 1, 2.4}, {0, 1, 0}, {1, 0, 0}, 2, 2, 2, 0);
  SolveOptions options;
  options.metres_per_unit = 0.5;
  const auto field = solved(grid, {material({0.5, 0.5, 0.5}, {10, 8, 0}), material({0.7, 0.4, 0.2})}, options);
  const mesh::EnergyLedger& energy = field.energy;
  EXPECT_NEAR(energy.emitted.x, 10 * 0.25, 1e-12);
  EXPECT_EQ(energy.emitted.z, 0);
  EXPECT_LT(energy.unshot_share(), 1e-3);
  EXPECT_GT(energy.unshot_share(), 0);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(energy.emitted[channel] + energy.reflected[channel], energy.shot[channel] + energy.unshot[channel],
                1e-9);
    EXPECT_NEAR(energy.shot[channel], energy.received[channel] + energy.escaped[channel], 1e-9);
    EXPECT_NEAR(energy.received[channel], energy.reflected[channel] + energy.absorbed[channel], 1e-9);
  }
  // Closed but for the back of the light, where what the ceiling above it reflects ends.
  EXPECT_GT(energy.absorbed.x, 0.9 * energy.emitted.x);
  EXPECT_LT(energy.escaped.x, 0.1 * energy.emitted.x);
}

TEST(Solver, TwiceTheLightIsTwiceTheRadiosity) {
  GridMesh grid(4);
  grid.add_box({0, 0, 0}, {2, 2, 2}, true, 2, 2, 1);
  grid.add_rectangle({0.5, 0.5, 1.9}, {0, 1, 0}, {1, 0, 0}, 2, 2, 1, 0);
  const auto once = solved(grid, {material(dvec3(0.2), {3, 2, 1}), material({0.6, 0.5, 0.4})});
  const auto twice = solved(grid, {material(dvec3(0.2), {6, 4, 2}), material({0.6, 0.5, 0.4})});
  for (std::size_t i = 0; i < once.radiosity.size(); ++i) EXPECT_EQ(twice.radiosity[i], once.radiosity[i] * 2.0);
}

TEST(Solver, LuminanceIsPiTimesItsExitance) {
  scene::Material light = material(dvec3(0), dvec3(1));
  light.emission_unit = scene::Material::EmissionUnit::Luminance;
  const auto field = solved(parallel_squares(2, 2), {light, material(dvec3(0.5))});
  EXPECT_NEAR(field.energy.emitted.x, std::numbers::pi, 1e-12);
  EXPECT_NEAR(field.radiosity.front().x, std::numbers::pi, 1e-12);
}

TEST(Solver, NodesOnAnEdgeWithAnEmitterGetHalfOfIt) {
  GridMesh grid(std::sqrt(3.0));
  grid.add_rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 4, 2, 0);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4, 2, 1);
  const auto field = solved(grid, {material(dvec3(0), dvec3(1)), material(dvec3(1.0 / 2))});
  int count = 0;
  for (std::size_t i = 0; i < grid.mesh.nodes.size(); ++i) {
    const mesh::Node& node = grid.mesh.nodes[i];
    if (node.normal.z < 0.5 || node.position.x > 0 || node.position.y < 0.2 || node.position.y > 0.8) continue;
    EXPECT_NEAR(field.radiosity[i].x, 0.25, 0.002);
    ++count;
  }
  EXPECT_EQ(count, 5);
}

TEST(Solver, APlateThatCoversTheLightBlocksAllOfIt) {
  GridMesh grid(3);
  grid.add_rectangle({0.4, 0.4, 1}, {0, 0.2, 0}, {0.2, 0, 0}, 1, 1, 1, 0);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4, 2, 1);
  grid.add_rectangle({-1, -1, 0.9}, {3, 0, 0}, {0, 3, 0}, 4, 4, 1, 2);
  const auto field = solved(grid, {material(dvec3(0), dvec3(1)), material(dvec3(0.5)), material(dvec3(0))});
  EXPECT_EQ(mean_radiosity(grid, field, 1), dvec3(0));
}

TEST(Solver, BacksNeitherEmitNorReceive) {
  GridMesh grid(2);
  grid.add_rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2, 2, 1, 0);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2, 1, 1);
  const auto field = solved(grid, kLightAndGrey);
  EXPECT_EQ(mean_radiosity(grid, field, 1), dvec3(0));
  EXPECT_EQ(field.energy.received, dvec3(0));
  EXPECT_EQ(field.energy.escaped, field.energy.emitted);
}

/// A long black half plane at mid height hides the part x < 2 edge - p of the light from the point p of the floor.
TEST(Solver, PenumbraOfAHalfPlaneIsTheFormFactorOfTheVisiblePart) {
  GridMesh grid(8);
  grid.add_rectangle({-0.5, -0.5, 2}, {0, 1, 0}, {1, 0, 0}, 1, 1, 1, 0);
  grid.add_rectangle({-2, -0.1, 0}, {4, 0, 0}, {0, 0.2, 0}, 40, 1, 1, 1);
  grid.add_rectangle({-6, -4, 1}, {6, 0, 0}, {0, 8, 0}, 2, 2, 1, 2);
  const auto field = solved(grid, {material(dvec3(0), dvec3(1)), material(dvec3(0.5)), material(dvec3(0))});
  double worst = 0, squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < grid.mesh.nodes.size(); ++i) {
    const dvec3& point = grid.mesh.nodes[i].position;
    if (point.z != 0) continue;
    const double left = std::clamp(-point.x, -0.5, 0.5);
    const Receiver receiver{point, {0, 0, 1}};
    const std::vector<dvec3> visible{{left, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}, {left, -0.5, 2}};
    const std::vector<dvec3> light{{-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}, {-0.5, -0.5, 2}};
    const double error = field.radiosity[i].x / 0.5 - form_factor(above_horizon(visible, receiver), receiver.normal);
    const double whole_light = form_factor(above_horizon(light, receiver), receiver.normal);
    worst = std::max(worst, std::abs(error) / whole_light);
    squares += error * error / (whole_light * whole_light);
    ++count;
  }
  EXPECT_EQ(count, 82);
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(std::sqrt(squares / count), 0.01);
}

GridMesh furnished_room() {
  GridMesh grid(5);
  grid.add_box({0, 0, 0}, {3, 2, 2}, true, 4, 2, 1);
  grid.add_box({0.5, 0.5, 0.3}, {1.1, 1, 0.8}, false, 2, 2, 2);
  grid.add_rectangle({1, 0.5, 1.9}, {0, 1, 0}, {1, 0, 0}, 2, 2, 2, 0);
  return grid;
}

const std::vector<scene::Material> kRoom{material(dvec3(0.3), {9, 8, 7}), material({0.8, 0.6, 0.4}),
                                         material({0.1, 0.3, 0.7})};

bool same_bits(const mesh::RadiosityField& a, const mesh::RadiosityField& b) {
  return a.shots == b.shots && a.radiosity.size() == b.radiosity.size() &&
         std::memcmp(a.radiosity.data(), b.radiosity.data(), a.radiosity.size() * sizeof(dvec3)) == 0 &&
         std::memcmp(&a.energy, &b.energy, sizeof a.energy) == 0;
}

TEST(Solver, GivesTheSameBitsWithAnyNumberOfThreads) {
  const GridMesh grid = furnished_room();
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    return solved(grid, kRoom);
  };
  const auto one = with_threads(1);
  EXPECT_GT(one.shots, 100u);
  EXPECT_TRUE(same_bits(one, with_threads(2)));
  EXPECT_TRUE(same_bits(one, with_threads(4)));
}

TEST(Solver, MemoryForCouplingsDoesNotChangeTheField) {
  const GridMesh grid = furnished_room();
  const auto all = solved(grid, kRoom);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{300'000}}) {
    SolveOptions options;
    options.coupling_bytes = bytes;
    EXPECT_TRUE(same_bits(all, solved(grid, kRoom, options)));
  }
}

TEST(Solver, StopsWhenToldTo) {
  const GridMesh grid = furnished_room();
  std::size_t calls = 0;
  Progress at_once([&](const ProgressState& state) {
    EXPECT_EQ(state.shots, 0u);
    EXPECT_NEAR(state.unshot_share, 1, 1e-12);
    ++calls;
    return false;
  });
  const auto field = solve(grid.mesh, kRoom, {}, at_once);
  EXPECT_EQ(calls, 1u);
  EXPECT_FALSE(field.complete);
  EXPECT_EQ(field.shots, 0u);
  EXPECT_EQ(field.radiosity[0], dvec3(0));
  EXPECT_NEAR(field.energy.unshot_share(), 1, 1e-12);
}

TEST(Solver, StopsAtTheShotLimit) {
  SolveOptions options;
  options.shot_limit = 21;
  const auto field = solved(furnished_room(), kRoom, options);
  EXPECT_FALSE(field.complete);
  EXPECT_EQ(field.shots, 21u);
  EXPECT_GT(field.energy.unshot_share(), 1e-3);
}

TEST(Solver, AStricterLimitComesCloserToTheLimit) {
  const GridMesh grid = furnished_room();
  SolveOptions options;
  options.unshot_limit = 1e-8;
  const auto exact = solved(grid, kRoom, options);
  double before = 1e300;
  for (const double limit : {1e-1, 1e-2, 1e-3, 1e-4}) {
    options.unshot_limit = limit;
    const auto field = solved(grid, kRoom, options);
    double error = 0, sum = 0;
    for (std::size_t i = 0; i < field.radiosity.size(); ++i) {
      error += std::abs(field.radiosity[i].x - exact.radiosity[i].x);
      sum += exact.radiosity[i].x;
    }
    EXPECT_LT(error / sum, limit * 5);  // 1/(1-ρ) of the unshot power is still to come, ρ = 0.8
    EXPECT_LT(error, before);
    before = error;
  }
}

TEST(Solver, WithoutLightThereIsNothingToDo) {
  const auto field = solved(parallel_squares(2, 2), {material(dvec3(0.5)), material(dvec3(0.5))});
  EXPECT_TRUE(field.complete);
  EXPECT_EQ(field.shots, 0u);
  EXPECT_EQ(field.energy.unshot_share(), 0);
}

TEST(Solver, AnEmptyMeshIsSolved) {
  Progress progress;
  const auto field = solve({}, kRoom, {}, progress);
  EXPECT_TRUE(field.complete);
  EXPECT_TRUE(field.radiosity.empty());
}

}  // namespace
}  // namespace rad::solve
