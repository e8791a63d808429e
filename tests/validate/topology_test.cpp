// Who shares an edge with whom, with all that noise below T can do to it.
#include "validate/topology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/support/derived_scene.h"

namespace rad::validate {
namespace {

using geom::dvec3;
using tests::DerivedScene;
using tests::SceneSketch;

constexpr double kT = 1.0 / 16;

DerivedScene derived(SceneSketch& sketch) { return {sketch.take(), kT}; }

std::size_t surfaces_of(const DerivedScene& scene) {
  const auto& surfaces = scene.topology.surface_of_face;
  return std::set<FaceId>(surfaces.begin(), surfaces.end()).size();
}

double volume_of(const DerivedScene& scene, const Component& component) {
  return static_cast<double>(component.volume6) / 6 * std::pow(scene.model.lattice.pitch, 3);
}

TEST(Topology, OfABoxIsOneClosedComponent) {
  SceneSketch sketch;
  sketch.box({0, 0, 0}, {2, 3, 4});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.subedges.size(), 12U);
  for (const Subedge& subedge : scene.topology.subedges) {
    const auto coedges = scene.topology.coedges_of(subedge);
    ASSERT_EQ(coedges.size(), 2U);
    EXPECT_NE(coedges[0].forward, coedges[1].forward);
  }
  ASSERT_EQ(scene.topology.components.size(), 1U);
  const Component& box = scene.topology.components[0];
  EXPECT_TRUE(box.closed());
  EXPECT_EQ(box.faces, 6U);
  EXPECT_EQ(box.subedges, 12U);
  EXPECT_EQ(box.smallest_point, 0U);
  EXPECT_DOUBLE_EQ(volume_of(scene, box), 24);
  EXPECT_DOUBLE_EQ(box.area * std::pow(scene.model.lattice.pitch, 2), 52);
  EXPECT_EQ(surfaces_of(scene), 6U) << "right angles part surfaces";
}

TEST(Topology, OfABoxThatLacksASideIsOpenAllAround) {
  SceneSketch sketch;
  sketch.box({0, 0, 0}, {2, 3, 4}, 5);
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_FALSE(scene.topology.components[0].closed());
  EXPECT_EQ(scene.topology.components[0].open_subedges, 4U);
  EXPECT_DOUBLE_EQ(scene.topology.components[0].open_length * scene.model.lattice.pitch, 10);
}

TEST(Topology, AnInwardBoxHasNegativeVolume) {
  SceneSketch sketch;
  sketch.box({2, 0, 0}, {0, 3, 4});
  const DerivedScene scene = derived(sketch);
  EXPECT_TRUE(scene.topology.components.at(0).closed());
  EXPECT_DOUBLE_EQ(volume_of(scene, scene.topology.components[0]), -24);
}

TEST(Topology, AFlippedFaceUnbalancesTheComponent) {
  SceneSketch sketch;
  sketch.box({0, 0, 0}, {2, 3, 4}, 5);
  sketch.face({{0, 0, 4}, {0, 3, 4}, {2, 3, 4}, {2, 0, 4}});
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_EQ(scene.topology.components[0].open_subedges, 0U);
  EXPECT_FALSE(scene.topology.components[0].balanced);
  EXPECT_FALSE(scene.topology.components[0].closed());
}

// One long edge against a chain of three: T-vertices, each a little off the edge.
TEST(Topology, AnEdgeWithTVerticesCountsAsTheChainThroughThem) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {9, -4, 0}, {0, -4, 0}});
  sketch.face({{0, 0, 0}, {0, 4, 0}, {3, 4, 0}, {3, kT / 2, 0}});
  sketch.face({{3, kT / 2, 0}, {3, 4, 0}, {6, 4, 0}, {6, -kT / 2, 0}});
  sketch.face({{6, -kT / 2, 0}, {6, 4, 0}, {9, 4, 0}, {9, 0, 0}});
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_EQ(scene.topology.subedges.size(), 3U + 3 + 3 + 2 + 2);
  EXPECT_EQ(scene.topology.components[0].open_subedges, 8U);
  EXPECT_EQ(surfaces_of(scene), 1U);
}

TEST(Topology, BeyondTNothingIsMatched) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {9, -4, 0}, {0, -4, 0}});
  sketch.face({{0, kT * 1.25, 0}, {0, 4, 0}, {9, 4, 0}, {9, kT * 1.25, 0}});
  EXPECT_EQ(derived(sketch).topology.components.size(), 2U);
}

TEST(Topology, CracksBelowTAreMatched) {
  SceneSketch sketch;
  sketch.box({0, 0, 0}, {2, 3, 4}, 5);
  sketch.face({{0, 0, 4 + kT / 2}, {2 + kT / 2, 0, 4}, {2, 3 - kT / 2, 4}, {0, 3, 4 - kT / 2}});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.subedges.size(), 12U);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_TRUE(scene.topology.components[0].closed());
  const PointId off = scene.point_at({0, 0, 4 + kT / 2}), on = scene.point_at({0, 0, 4});
  EXPECT_EQ(scene.topology.representative.at(off), scene.topology.representative.at(on));
}

// A row of vertices, each within T of the next: representatives stay within T of what they stand for.
TEST(Topology, ChainsOfNearVerticesDoNotDrift) {
  SceneSketch sketch;
  for (int i = 0; i < 12; ++i) sketch.face({{i * kT * 0.75, 0, 0}, {0.25 * i, 9, 4}, {0.25 * i, -9, 4}});
  const DerivedScene scene = derived(sketch);
  for (PointId id = 0; id < scene.model.points.size(); ++id) {
    const PointId standing = scene.topology.representative[id];
    EXPECT_TRUE(geom::points_within(scene.model.points[id], scene.model.points[standing], scene.tolerance.pitches));
    EXPECT_EQ(scene.topology.representative[standing], standing);
  }
}

TEST(Topology, BoxesOfDifferentNamesThatShareAnEdgeStayApart) {
  SceneSketch sketch;
  sketch.use("left", "");
  sketch.box({0, 0, 0}, {2, 2, 2});
  sketch.use("right", "");
  sketch.box({2, 2, 0}, {4, 4, 2});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.subedges.size(), 23U);
  ASSERT_EQ(scene.topology.components.size(), 2U);
  for (const Component& box : scene.topology.components) {
    EXPECT_TRUE(box.closed());
    EXPECT_EQ(box.faces, 6U);
  }
}

TEST(Topology, BoxesOfOneNameThatShareAnEdgeAreOneComponent) {
  SceneSketch sketch;
  sketch.use("both", "");
  sketch.box({0, 0, 0}, {2, 2, 2});
  sketch.box({2, 2, 0}, {4, 4, 2});
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_TRUE(scene.topology.components[0].closed());
}

TEST(Topology, TwoObjectsThatCloseEachOtherAreOneComponent) {
  SceneSketch sketch;
  sketch.use("walls", "");
  sketch.box({0, 0, 0}, {2, 3, 4}, 5);
  sketch.use("roof", "");
  sketch.face({{0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}});
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 1U);
  EXPECT_TRUE(scene.topology.components[0].closed());
}

TEST(Topology, BridgesCancel) {
  SceneSketch sketch;
  const dvec3 a{0, 0, 0}, b{9, 0, 0}, c{9, 9, 0}, d{0, 9, 0}, p{2, 2, 0}, q{2, 6, 0}, r{6, 6, 0}, s{6, 2, 0};
  sketch.face({a, p, q, r, s, p, a, b, c, d});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.subedges.size(), 8U) << "the bridge from a to p is used both ways by one face";
  EXPECT_EQ(scene.topology.components.at(0).open_subedges, 8U);
}

TEST(Topology, HolesBoundTheirFace) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
  sketch.hole({{2, 2, 0}, {2, 6, 0}, {6, 6, 0}, {6, 2, 0}});
  sketch.face({{2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.components.size(), 1U);
  EXPECT_EQ(scene.topology.components[0].open_subedges, 4U);
}

TEST(Topology, FacesWithoutAreaBelongToNoComponent) {
  SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {4, kT / 2, 0}});
  sketch.face({{0, 0, 4}, {9, 0, 4}, {4, 4, 4}});
  const DerivedScene scene = derived(sketch);
  EXPECT_EQ(scene.topology.component_of_face, (std::vector<std::uint32_t>{kNoComponent, 0}));
}

// A needle a little thicker than T whose point is a T-vertex of its own long edge once it counts as the corner of the
// sheet below: nothing of its outline is left, but it encloses nothing either.
TEST(Topology, ANeedleThatCollapsesIsNotClosed) {
  SceneSketch sketch;
  sketch.face({{1, -4, 4}, {9, -2, 4}, {5, -3, 4 + kT * 1.1}});
  sketch.face({{0, -4, 4 + kT * 0.9}, {5, -4, 4 + kT * 0.9}, {5, -3, 4 + kT * 0.9}, {0, -3, 4 + kT * 0.9}});
  const DerivedScene scene = derived(sketch);
  const Component& needle = scene.topology.components.at(scene.topology.component_of_face.at(0));
  EXPECT_EQ(needle.subedges, 0U);
  EXPECT_FALSE(needle.closed());
}

// A fan of flat strips around an axis, turning by the given angle from one to the next.
DerivedScene bent_strips(double degrees, std::string_view second_material) {
  SceneSketch sketch;
  dvec3 here{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const double angle = i * degrees * std::numbers::pi / 180;
    const dvec3 next = here + dvec3(4 * std::cos(angle), 0, 4 * std::sin(angle));
    sketch.use("strip", i == 1 ? second_material : "plaster");
    sketch.face({here, next, next + dvec3(0, 5, 0), here + dvec3(0, 5, 0)});
    here = next;
  }
  return derived(sketch);
}

TEST(Topology, SurfacesEndAtSharpEdgesAndOtherMaterials) {
  EXPECT_EQ(surfaces_of(bent_strips(0, "plaster")), 1U);
  EXPECT_EQ(surfaces_of(bent_strips(29.5, "plaster")), 1U);
  EXPECT_EQ(surfaces_of(bent_strips(30.5, "plaster")), 3U);
  EXPECT_EQ(surfaces_of(bent_strips(10, "glass")), 3U);
}

TEST(Topology, ComponentsAreNumberedByTheirSmallestPoint) {
  SceneSketch sketch;
  sketch.box({6, 0, 0}, {8, 2, 2});
  sketch.box({-6, 0, 0}, {-4, 2, 2});
  sketch.box({0, 0, 0}, {2, 2, 2});
  const DerivedScene scene = derived(sketch);
  ASSERT_EQ(scene.topology.components.size(), 3U);
  EXPECT_EQ(scene.topology.component_of_face[0], 2U);
  EXPECT_EQ(scene.topology.component_of_face[6], 0U);
  EXPECT_EQ(scene.topology.component_of_face[12], 1U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_LT(scene.topology.components[i - 1].smallest_point, scene.topology.components[i].smallest_point);
  }
}

}  // namespace
}  // namespace rad::validate
