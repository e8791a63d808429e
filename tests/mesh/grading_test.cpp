// Patches grow gradually from short edges and narrow places.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mesh/statistics.h"
#include "tests/mesh/sound_patches.h"

namespace rad::tests {
namespace {

// A face with an edge of a hundredth, a notch, a hole and a slot.
ConformingBuilder notched_face() {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(10, 0), at(10, 6), at(5.1, 6), at(5.1, 5.8), at(4.9, 5.8), at(4.9, 6), at(0, 6)},
                   {{at(2, 2), at(2, 3.7), at(3.1, 3.9), at(3.3, 2.2)}, {at(7, 1), at(7, 1.2), at(9, 1.2), at(9, 1)}});
  return builder;
}

mesh::PatchMesh with_method(const ConformingBuilder& builder, double longest, mesh::PatchMethod method) {
  mesh::PatchOptions options;
  options.longest_edge = longest;
  options.method = method;
  return *mesh::pmesh(builder.model(), options).mesh;
}

TEST(Grading, KeepsPatchesInGoodShape) {
  const mesh::PatchMesh graded = expect_sound(notched_face(), 0.5, false, mesh::PatchMethod::Graded);
  const mesh::PatchStatistics statistics = mesh::patch_statistics(graded);
  EXPECT_GE(statistics.blunt_shape.first, 0.5);
  EXPECT_GE(statistics.blunt_shape.median, 0.85);
  const auto grid = mesh::patch_statistics(with_method(notched_face(), 0.5, mesh::PatchMethod::Grid));
  EXPECT_LT(grid.blunt_shape.first, statistics.blunt_shape.first) << "the paper's grid leaves slivers";
  EXPECT_LT(graded.patches.n_faces(), 3000U) << "an even grid as fine as the slot has 4 million";
}

TEST(Grading, MakesSquaresOfThinStrips) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 8, 0.2));
  const auto statistics = mesh::patch_statistics(expect_sound(builder, 1, false, mesh::PatchMethod::Graded));
  EXPECT_GE(statistics.shape.first, 0.5);
  EXPECT_EQ(statistics.triangles, 0U);
}

// Both sides of an edge read its division from the edge.
TEST(Grading, IsAlikeOnBothSidesOfAnEdge) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(8, 0), at(8, 5), at(0, 5)});
  builder.add_face({at(0, 0), at(0, 0, -0.2), at(8, 0, -0.2), at(8, 0)});
  const mesh::PatchMesh mesh = expect_sound(builder, 1, false, mesh::PatchMethod::Graded);
  std::size_t along = 0;
  for (const LatticePoint& p : mesh.points) along += p.y == 0 && p.z == 0 ? 1U : 0U;
  EXPECT_GT(along, 20U) << "the strip asks for short edges, and the wall has them too";
}

TEST(Grading, NeighboursDifferLittleInSize) {
  const mesh::PatchMesh mesh = with_method(notched_face(), 0.5, mesh::PatchMethod::Graded);
  std::size_t pairs = 0, large_steps = 0;
  const auto area = [&](auto face) {
    std::vector<geom::dvec3> ring;
    for (const auto vertex : face.vertices()) {
      ring.push_back(geom::as_vector(mesh.points[mesh.patches.data(vertex).lattice_point]));
    }
    geom::dvec3 sum(0, 0, 0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    return glm::length(sum) / 2;
  };
  for (const auto edge : mesh.patches.edges()) {
    if (edge.is_boundary()) continue;
    const double a = area(edge.h0().face()), b = area(edge.h1().face());
    ++pairs;
    large_steps += std::max(a, b) > 6 * std::min(a, b) ? 1U : 0U;
  }
  EXPECT_LT(large_steps * 100, pairs * 2) << "of " << pairs;
}

TEST(Grading, FacesMayHaveLengthsOfTheirOwn) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 4));
  builder.add_face(rectangle(0, 0, 4, 4, 3));
  mesh::PatchOptions options;
  options.longest_edge = 1;
  options.longest_of_face = {0, 0.5};
  EXPECT_EQ(mesh::pmesh(builder.model(), options).mesh->patches.n_faces(), 16U + 64U);
}

}  // namespace
}  // namespace rad::tests
