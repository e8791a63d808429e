// Distances from vertices to vertices and edges, against all pairs.
#include "scene/near_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "scene/scene_builder.h"

namespace rad::scene {
namespace {

Scene soup(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 10), step(-0.02, 0.02);
  SceneBuilder builder("soup.obj", "obj");
  builder.add_section({"soup.obj", "", RecordKind::Line});
  for (int i = 0; i < 60; ++i) {
    const dvec3 middle(place(random), place(random), place(random));
    std::vector<VertexId> ids;
    for (int k = 0; k < 3; ++k) {
      ids.push_back(builder.add_vertex(middle + dvec3(step(random), step(random), step(random))));
    }
    builder.add_face(ids, 1);
  }
  return builder.take();
}

std::vector<double> by_all_pairs(const Scene& scene, const LatticeModel& model) {
  const double reach = 1e-2 * model.box.diagonal() / model.lattice.pitch;
  std::vector<double> distances;
  for (PointId point = 0; point < model.points.size(); ++point) {
    double to_vertex = INFINITY, to_edge = INFINITY;
    const dvec3 here = geom::as_vector(model.points[point]);
    for (const Loop& loop : scene.loops) {
      const auto corners = model.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId a = corners[i], b = corners[(i + 1) % corners.size()];
        const dvec3 from = geom::as_vector(model.points[std::min(a, b)]);
        const dvec3 to = geom::as_vector(model.points[std::max(a, b)]);
        if (a != point) to_vertex = std::min(to_vertex, glm::distance(here, geom::as_vector(model.points[a])));
        if (a != point && b != point) to_edge = std::min(to_edge, geom::distance_to_segment(here, from, to));
      }
    }
    // An edge farther off than the nearest vertex of the own faces is of no account.
    for (const double distance : {to_vertex, to_edge}) {
      if (distance > 2 && distance <= reach) distances.push_back(distance * model.lattice.pitch);
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(NearDistances, AgreeWithAllPairs) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = soup(seed);
    const LatticeModel model = build_lattice_model(scene);
    const auto found = near_distances(scene, model);
    const auto all = by_all_pairs(scene, model);
    // The search stops at the shortest edge of a vertex: what it leaves out is farther than what it found there.
    EXPECT_TRUE(std::ranges::includes(all, found));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front(), all.front());
    EXPECT_GE(2 * found.size(), all.size());
  }
}

TEST(NearDistances, SeeATVertexBesideItsEdge) {
  SceneBuilder builder("t.obj", "obj");
  builder.add_section({"t.obj", "", RecordKind::Line});
  const auto face = [&](std::vector<dvec3> places) {
    std::vector<VertexId> ids;
    for (const dvec3& p : places) ids.push_back(builder.add_vertex(p));
    builder.add_face(ids, 1);
  };
  face({{0, 0, 0}, {8, 0, 0}, {4, 8, 0}});
  face({{4, -1e-4, 0}, {1, -7, 0}, {7, -7, 0}});
  const Scene scene = builder.take();
  const auto found = near_distances(scene, build_lattice_model(scene));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 1e-4, 2e-6);
}

}  // namespace
}  // namespace rad::scene
