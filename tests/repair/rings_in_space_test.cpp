// Faces so warped that their rings cross in their plane and pass each other in space.
#include "repair/rings_in_space.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "repair/distance.h"
#include "repair/repair.h"
#include "scene/scene_builder.h"

namespace rad::repair {
namespace {

using geom::LatticePoint;

constexpr std::int64_t kTolerance = 8;

double area_of(std::span<const LatticePoint> ring, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double area = 0;
  for (const auto& [i, j, k] : triangles) {
    const dvec3 a = geom::as_vector(ring[i]);
    area += glm::length(glm::cross(geom::as_vector(ring[j]) - a, geom::as_vector(ring[k]) - a)) / 2;
  }
  return area;
}

/// Seen from above two edges cross; one passes 900 pitches over the other.
const std::vector<LatticePoint> kFolded{{0, 0, 0}, {4000, 4000, 0}, {4000, 0, 900}, {0, 4000, 900}};

TEST(RingsInSpace, EdgesThatPassEachOtherDoNotMeet) {
  EXPECT_FALSE(meets_itself(kFolded, kTolerance));
  EXPECT_FALSE(meets_itself(std::vector<LatticePoint>{{0, 0, 0}, {90, 0, 0}, {0, 90, 0}}, kTolerance));
}

TEST(RingsInSpace, EdgesWithinTheToleranceMeet) {
  const auto crossed_at = [](std::int32_t height) {
    return std::vector<LatticePoint>{{0, 0, 0}, {4000, 4000, 0}, {4000, 0, height}, {0, 4000, height}};
  };
  EXPECT_TRUE(meets_itself(crossed_at(kTolerance), kTolerance));
  EXPECT_FALSE(meets_itself(crossed_at(kTolerance + 1), kTolerance));
}

TEST(RingsInSpace, TrianglesHaveEveryCornerAndFollowTheRing) {
  const auto triangles = least_area_triangles(kFolded);
  ASSERT_EQ(triangles.size(), 2u);
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second);
  }
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_TRUE(edges.contains({i, (i + 1) % 4}));
}

TEST(RingsInSpace, NoFanHasLessArea) {
  const std::vector<LatticePoint> ring{{0, 0, 0},       {900, -400, 300}, {2000, 100, -500},
                                       {1700, 900, 80}, {800, 300, 700},  {100, 1000, -60}};
  const double least = area_of(ring, least_area_triangles(ring));
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (std::uint32_t start = 0; start < count; ++start) {
    std::vector<std::array<std::uint32_t, 3>> fan;
    for (std::uint32_t i = 1; i + 1 < count; ++i) fan.push_back({start, (start + i) % count, (start + i + 1) % count});
    EXPECT_LE(least, area_of(ring, fan));
  }
}

TEST(RingsInSpace, RingsOfLessThanThreeCornersHaveNoTriangles) {
  EXPECT_TRUE(least_area_triangles({}).empty());
  EXPECT_TRUE(least_area_triangles(std::vector<LatticePoint>{{0, 0, 0}, {1, 1, 1}}).empty());
}

/// A strip whose far end is bent so much that its ring crosses in its own plane, as stairs are drawn.
TEST(RingsInSpace, RepairKeepsTheSurfaceOfAFoldedFace) {
  scene::SceneBuilder builder("stair.obj", "obj");
  const std::vector<dvec3> ring{{4.357, -19.009, 79.511},  {51.482, -65.427, 77.806}, {52.247, -66.679, 77.366},
                                {48.884, -66.637, 77.346}, {45.334, -65.452, 77.338}, {41.563, -63.004, 77.346},
                                {29.390, -50.159, 77.420}, {8.106, -22.173, 78.893}};
  std::vector<scene::VertexId> ids;
  for (const dvec3& p : ring) ids.push_back(builder.add_vertex(p));
  builder.add_section({"stair.obj", {}, scene::RecordKind::Line});
  builder.add_face(ids, 1);
  const Repaired repaired = repair(builder.take(), {}, {});
  const scene::ConformingModel& model = repaired.model;
  const auto off = [&](const dvec3& place) {
    double least = 1e9;
    for (const auto& face : model.faces) {
      for (const auto& t : model.triangles_of(face)) {
        const auto corner = [&](int i) {
          return model.lattice.origin + model.lattice.pitch * geom::as_vector(model.points[t[i]]);
        };
        least = std::min(least, distance_to_triangle(place, std::array{corner(0), corner(1), corner(2)}));
      }
    }
    return least;
  };
  // Within the height of the ring over its plane, 0.56, everywhere between the long sides.
  for (const dvec3& inside : {dvec3(32.86, -50.37, 78.07), dvec3(20, -37, 78.4), dvec3(40, -58, 77.7)}) {
    EXPECT_LT(off(inside), 1.0);
  }
  EXPECT_EQ(repaired.unresolved, 0u);
}

}  // namespace
}  // namespace rad::repair
