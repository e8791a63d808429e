// The search finds what comparing every triangle with every other finds.
#include "validate/contacts.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "tests/support/derived_scene.h"
#include "tests/support/random_scenes.h"

namespace rad::validate {
namespace {

using geom::ContactKind;
using tests::DerivedScene;
using tests::SceneSketch;

constexpr double kT = tests::kSceneTolerance;

bool has(const FaceTriangle& triangle, PointId id) {
  return std::find(triangle.points.begin(), triangle.points.end(), id) != triangle.points.end();
}

// Vertices near edges and vertices of one triangle's corners against another triangle, from the definitions.
struct AllPairs {
  const DerivedScene& scene;
  std::set<VertexOnEdge> vertices_on_edges;
  std::set<NearVertices> near_vertices;

  explicit AllPairs(const DerivedScene& derived) : scene(derived) {
    const auto& triangles = scene.triangles.triangles;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = 0; j < triangles.size(); ++j) {
        if (triangles[i].face == triangles[j].face) continue;
        for (const PointId vertex : triangles[i].points) {
          if (!has(triangles[j], vertex)) compare(vertex, triangles[i].face, j);
        }
      }
    }
  }

  void compare(PointId vertex, FaceId face, std::size_t other) {
    const FaceTriangle& triangle = scene.triangles.triangles[other];
    const auto& points = scene.model.points;
    const std::int64_t t = scene.tolerance.pitches;
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId a = triangle.points[k], b = triangle.points[(k + 1) % 3];
      if (geom::points_within(points[vertex], points[a], t)) {
        near_vertices.insert(vertex < a ? NearVertices{vertex, a, face, triangle.face}
                                        : NearVertices{a, vertex, triangle.face, face});
      }
      if (scene.triangles.geometry[other].boundary[k] &&
          geom::point_within_segment(points[vertex], points[a], points[b], t) &&
          geom::foot_inside_segment(points[vertex], points[a], points[b], t)) {
        vertices_on_edges.insert({{std::min(a, b), std::max(a, b)}, vertex, triangle.face, face});
      }
    }
  }
};

template <typename Item>
std::vector<Item> in_order(const std::set<Item>& items) {
  return {items.begin(), items.end()};
}

TEST(Contacts, FindAllVerticesNearEdgesAndVertices) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const DerivedScene scene(seed % 4 == 0 ? tests::coarse_scene(seed) : tests::fine_scene(seed), kT);
    const AllPairs expected(scene);
    ASSERT_EQ(scene.contacts.vertices_on_edges, in_order(expected.vertices_on_edges)) << "seed " << seed;
    ASSERT_EQ(scene.contacts.near_vertices, in_order(expected.near_vertices)) << "seed " << seed;
  }
}

using PairKey = std::tuple<FaceId, FaceId, ContactKind, bool>;

// Every pair of triangles through the judgement of contacts, without boxes.
std::set<PairKey> touching_pairs(const DerivedScene& scene) {
  std::set<PairKey> pairs;
  const auto& all = scene.triangles;
  const std::int64_t t = scene.tolerance.pitches;
  for (std::size_t i = 0; i < all.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < all.triangles.size(); ++j) {
      const FaceId a = all.triangles[i].face, b = all.triangles[j].face;
      const geom::LatticeTriangle &ga = all.geometry[i], &gb = all.geometry[j];
      const geom::Sides a_sides = geom::sides_of(ga, gb.plane, t), b_sides = geom::sides_of(gb, ga.plane, t);
      if (a == b || geom::all_on_one_side(a_sides) || geom::all_on_one_side(b_sides)) continue;
      const geom::TriangleContact contact = geom::contact_of(ga, a_sides, gb, b_sides, t);
      if (contact.kind == ContactKind::Overlap) pairs.emplace(a, b, contact.kind, contact.same_facing);
    }
  }
  return pairs;
}

TEST(Contacts, FindAllOverlaps) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const DerivedScene scene(seed % 4 == 0 ? tests::coarse_scene(seed) : tests::fine_scene(seed), kT);
    std::set<PairKey> pairs;
    for (const FaceContact& c : scene.contacts.faces) {
      if (c.kind == ContactKind::Overlap) pairs.emplace(c.a, c.b, c.kind, c.same_facing);
    }
    found += pairs.size();
    ASSERT_EQ(pairs, touching_pairs(scene)) << "seed " << seed;
  }
  EXPECT_GT(found, 200U);
}

auto tied(const FaceContact& c) {
  return std::tie(c.a, c.b, c.kind, c.same_facing, c.size, c.segment[0].x, c.segment[0].y, c.segment[0].z,
                  c.segment[1].x, c.segment[1].y, c.segment[1].z);
}

TEST(Contacts, DoNotDependOnThreads) {
  tests::RandomScene large(7);
  for (int i = 0; i < 400; ++i) large.add_box();
  const DerivedScene scene(large.take(), kT);
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    return find_contacts(scene.triangles, scene.tolerance);
  };
  const Contacts one = with_threads(1), two = with_threads(2);
  ASSERT_EQ(one.faces.size(), two.faces.size());
  EXPECT_GT(one.faces.size(), 10000U);
  for (std::size_t i = 0; i < one.faces.size(); ++i) ASSERT_EQ(tied(one.faces[i]), tied(two.faces[i]));
  EXPECT_EQ(one.vertices_on_edges, two.vertices_on_edges);
  EXPECT_EQ(one.near_vertices, two.near_vertices);
}

// A crowded scene is searched in part; the part is the same for any number of threads, and the whole is not said to be
// one.
TEST(Contacts, LimitsAreSaidAndDoNotDependOnThreads) {
  tests::RandomScene crowd(11);
  for (int i = 0; i < 400; ++i) crowd.add_box();
  const DerivedScene scene(crowd.take(), kT);
  SearchLimits narrow;
  narrow.contacts = 1000;
  narrow.least_contacts = 100;
  const auto searched = [&](std::size_t threads, const SearchLimits& limits) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return find_contacts(scene.triangles, scene.tolerance, limits);
  };
  const Contacts whole = searched(2, {}), one = searched(1, narrow), two = searched(2, narrow);
  EXPECT_FALSE(whole.truncated);
  EXPECT_TRUE(one.truncated);
  EXPECT_GT(whole.faces.size(), one.faces.size());
  ASSERT_EQ(one.faces.size(), two.faces.size());
  for (std::size_t i = 0; i < one.faces.size(); ++i) ASSERT_EQ(tied(one.faces[i]), tied(two.faces[i]));
  narrow = {};
  narrow.pairs = narrow.least_pairs = 100;
  EXPECT_TRUE(searched(2, narrow).truncated);
}

// A square floor, and a wall that stands on its diagonal: whichever diagonal the floor is cut along.
TEST(Contacts, AWallOnTheDiagonalOfAFloorIsFound) {
  for (const double turn : {1.0, -1.0}) {
    SceneSketch sketch;
    sketch.face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
    const double from = turn > 0 ? 0 : 8, to = 8 - from;
    sketch.face({{from, 0, 0}, {to, 8, 0}, {to, 8, 4}, {from, 0, 4}});
    const DerivedScene scene(sketch.take(), kT);
    ASSERT_EQ(scene.contacts.faces.size(), 1U);
    EXPECT_EQ(scene.contacts.faces[0].kind, ContactKind::EdgeInFace);
    EXPECT_NEAR(scene.contacts.faces[0].size * scene.model.lattice.pitch, 8 * std::sqrt(2), 1e-3);
  }
}

TEST(Contacts, FacesThatCrossAlongTheirDiagonalsAreFound) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  sketch.face({{0, 0, 0}, {4, 4, 5}, {8, 8, 0}, {4, 4, -5}});
  const DerivedScene scene(sketch.take(), kT);
  ASSERT_EQ(scene.contacts.faces.size(), 1U);
  EXPECT_EQ(scene.contacts.faces[0].kind, ContactKind::Crossing);
  EXPECT_NEAR(scene.contacts.faces[0].size * scene.model.lattice.pitch, 8 * std::sqrt(2), 1e-3);
}

// The floor ends a third of T above the foot of a long wall. The diagonal of the wall runs so flat there that a stretch
// longer than T belongs to the triangle that does not have the lower edge.
TEST(Contacts, ADiagonalNearTheOutlineMakesNoContact) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {40, 0, 0}, {40, 0, 2}, {0, 0, 2}});
  sketch.face({{0, -8, kT / 3}, {40, -8, kT / 3}, {40, 0, kT / 3}, {0, 0, kT / 3}});
  const DerivedScene scene(sketch.take(), kT);
  EXPECT_TRUE(scene.contacts.faces.empty());
  EXPECT_EQ(scene.contacts.near_vertices.size(), 2U);
}

}  // namespace
}  // namespace rad::validate
