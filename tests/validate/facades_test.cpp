// Verdicts on facades in conforming models: what is proved, and that the proofs hold.
#include "validate/facades.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "geom/triangle_meeting.h"
#include "tests/support/derived_scene.h"
#include "tests/support/scene_variants.h"
#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

using geom::LatticePoint;
using scene::Scene;

constexpr double kT = 1.0 / 256;

Context context_of(const Scene& scene) {
  static const scene::ReadIssues kNone;
  std::string refusal;
  return build_context(scene, kNone, geom::ToleranceRequest{kT, geom::ToleranceRequest::Measure::FileUnits}, refusal)
      .value();
}

/// Verdicts on the components that are open, in the order of space.
std::vector<FacadeVerdict> verdicts_on(const Scene& scene) {
  const Context context = context_of(scene);
  std::vector<FacadeVerdict> verdicts;
  for (std::size_t i = 0; i < context.topology.components.size(); ++i) {
    if (context.topology.components[i].open_subedges > 0)
      verdicts.push_back(facades_of(context).of_component[i].verdict);
  }
  return verdicts;
}

using Verdicts = std::vector<FacadeVerdict>;

std::vector<scene::dvec3> rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

std::vector<scene::dvec3> reversed(std::vector<scene::dvec3> ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

/// A slab with the outline of what stands on it drawn in, and a box without a bottom `height` above it.
Scene box_over_slab(double height) {
  tests::SceneSketch sketch;
  sketch.use("slab", "stone");
  sketch.box({0, 0, -1}, {12, 12, 0}, 5);
  sketch.face(rectangle(0, 0, 12, 12, 0));
  if (height == 0) {
    sketch.hole(reversed(rectangle(4, 4, 8, 8, 0)));
    sketch.face(rectangle(4, 4, 8, 8, 0));
  }
  sketch.use("box", "wood");
  sketch.box({4, 4, height}, {8, 8, 4}, 4);
  return sketch.take();
}

Scene with_light(Scene scene, const std::string& material) {
  for (scene::Material& m : scene.materials) {
    if (m.name == material) m.emission = {100, 100, 100};
  }
  return scene;
}

TEST(Facades, ABoxWithoutABottomOnTheFloorIsValid) {
  EXPECT_EQ(verdicts_on(box_over_slab(0)), (Verdicts{FacadeVerdict::ValidProved}));
}

TEST(Facades, ABoxWithoutABottomOverTheFloorIsNot) {
  for (const double height : {2 * kT, 20 * kT, 1.0}) {
    EXPECT_EQ(verdicts_on(box_over_slab(height)), (Verdicts{FacadeVerdict::InvalidProved})) << height;
  }
}

TEST(Facades, TheGapUnderTheBoxIsMeasured) {
  for (const double gaps : {2.0, 3.0, 19.0}) {
    const Scene scene = box_over_slab(gaps * kT);
    const Context context = context_of(scene);
    for (const Facade& facade : facades_of(context).of_component) {
      if (facade.verdict != FacadeVerdict::InvalidProved) continue;
      ASSERT_TRUE(facade.gap.has_value());
      EXPECT_NEAR(facade.gap->width / static_cast<double>(context.tolerance.pitches), gaps, 1e-9);
    }
  }
  const Scene high = box_over_slab(1);
  const Context context = context_of(high);
  for (const Facade& facade : facades_of(context).of_component) EXPECT_FALSE(facade.gap.has_value());
}

TEST(Facades, AFlippedFaceLeavesItUndecided) {
  Scene scene = box_over_slab(0);
  std::swap(scene.corners[scene.loops.back().first], scene.corners[scene.loops.back().first + 2]);
  EXPECT_EQ(verdicts_on(scene), (Verdicts{FacadeVerdict::Undecided}));
}

// The box stands on a slab into which its rim is not drawn: RL211 has to be cured first.
TEST(Facades, AModelThatIsNotConformingLeavesItUndecided) {
  tests::SceneSketch sketch;
  sketch.use("slab", "stone");
  sketch.box({0, 0, -1}, {12, 12, 0});
  sketch.use("box", "wood");
  sketch.box({4, 4, 0}, {8, 8, 4}, 4);
  EXPECT_EQ(verdicts_on(sketch.take()), (Verdicts{FacadeVerdict::Undecided}));
}

/// A room of inward sheets with a lamp in it; closed, with a poster of one sheet in the middle, or with a slit in a
/// wall.
Scene room_with_poster(bool lit, double slit) {
  tests::SceneSketch sketch;
  sketch.use("room", "wall");
  for (const auto& ring : {rectangle(0, 0, 16, 12, 0), reversed(rectangle(0, 0, 16, 12, 8))}) sketch.face(ring);
  sketch.face({{0, 0, 0}, {0, 0, 8}, {16, 0, 8}, {16, 0, 0}});
  sketch.face({{0, 12, 0}, {16, 12, 0}, {16, 12, 8}, {0, 12, 8}});
  sketch.face({{0, 0, 0}, {0, 12, 0}, {0, 12, 8}, {0, 0, 8}});
  sketch.face({{16, 0, 0}, {16, 0, 8}, {16, 12, 8}, {16, 12, 0}});
  if (slit > 0) {
    sketch.hole({{16, 6, 1}, {16, 6 + slit, 1}, {16, 6 + slit, 7}, {16, 6, 7}});
  } else {
    sketch.use("poster", "paper");
    sketch.face({{8, 4, 2}, {8, 8, 2}, {8, 8, 6}, {8, 4, 6}});
  }
  sketch.use("lamp", "lamp");
  sketch.box({2, 2, 6}, {3, 3, 7});
  return lit ? with_light(sketch.take(), "lamp") : sketch.take();
}

TEST(Facades, APosterInARoomIsSeenFromBehind) {
  for (const bool lit : {false, true}) {
    EXPECT_EQ(verdicts_on(room_with_poster(lit, 0)), (Verdicts{FacadeVerdict::InvalidProved}));
  }
}

// Light gets out through a slit, and the room's walls are seen from behind; nothing outside shows a front.
TEST(Facades, ASlitLetsLightOutOfARoom) {
  for (const double slit : {2 * kT, 0.25}) {
    EXPECT_EQ(verdicts_on(room_with_poster(false, slit)), (Verdicts{FacadeVerdict::InvalidProved})) << slit;
    EXPECT_EQ(verdicts_on(room_with_poster(true, slit)), (Verdicts{FacadeVerdict::ProbablyValid})) << slit;
  }
}

// A room in a room; the lamp is in the outer one, and a poster in the inner one or in the outer one.
TEST(Facades, ARoomWithinARoomIsDark) {
  for (const bool poster_in_light : {false, true}) {
    tests::SceneSketch sketch;
    const auto inward_box = [&](const scene::dvec3& low, const scene::dvec3& high) {
      const auto ring = [&](double z) { return rectangle(low.x, low.y, high.x, high.y, z); };
      const auto low_ring = ring(low.z), high_ring = ring(high.z);
      sketch.face(low_ring);
      sketch.face(reversed(high_ring));
      for (std::size_t i = 0; i < 4; ++i) {
        sketch.face({low_ring[(i + 1) % 4], low_ring[i], high_ring[i], high_ring[(i + 1) % 4]});
      }
    };
    sketch.use("outer", "wall");
    inward_box({0, 0, 0}, {20, 20, 10});
    sketch.use("inner", "wall");
    inward_box({2, 2, 2}, {8, 8, 8});
    sketch.use("lamp", "lamp");
    sketch.box({15, 15, 8}, {16, 16, 9});
    sketch.use("poster", "paper");
    const double x = poster_in_light ? 12 : 5;
    sketch.face({{x, 4, 4}, {x, 6, 4}, {x, 6, 6}, {x, 4, 6}});
    const FacadeVerdict expected = poster_in_light ? FacadeVerdict::InvalidProved : FacadeVerdict::ValidProved;
    EXPECT_EQ(verdicts_on(with_light(sketch.take(), "lamp")), (Verdicts{expected}));
  }
}

TEST(Facades, AGroundPlaneIsTerrain) {
  tests::SceneSketch sketch;
  sketch.use("ground", "grass");
  sketch.face(rectangle(0, 0, 40, 40, 0));
  sketch.use("house", "brick");
  sketch.box({10, 10, 1}, {20, 20, 6});
  EXPECT_EQ(verdicts_on(sketch.take()), (Verdicts{FacadeVerdict::Terrain}));
}

TEST(Facades, WhatIsSunkIntoTheGroundDoesNotMatter) {
  tests::SceneSketch sketch;
  sketch.use("ground", "grass");
  sketch.face(rectangle(0, 0, 40, 40, 0));
  sketch.hole(reversed(rectangle(10, 10, 12, 12, 0)));
  sketch.use("post", "iron");
  for (const double low : {-3.0, 0.0}) {
    const auto bottom = rectangle(10, 10, 12, 12, low), top = rectangle(10, 10, 12, 12, low + 3);
    for (std::size_t i = 0; i < 4; ++i) sketch.face({bottom[i], bottom[(i + 1) % 4], top[(i + 1) % 4], top[i]});
  }
  sketch.face(reversed(rectangle(10, 10, 12, 12, -3)));
  sketch.face(rectangle(10, 10, 12, 12, 3));
  EXPECT_EQ(verdicts_on(sketch.take()), (Verdicts{FacadeVerdict::Terrain}));
}

// The same plane with something under it is seen from there.
TEST(Facades, AGroundPlaneOverACellarIsNot) {
  tests::SceneSketch sketch;
  sketch.use("ground", "grass");
  sketch.face(rectangle(0, 0, 40, 40, 0));
  sketch.use("house", "brick");
  sketch.box({10, 10, -6}, {30, 30, -1});
  EXPECT_EQ(verdicts_on(sketch.take()), (Verdicts{FacadeVerdict::InvalidProved}));
}

TEST(Facades, ASheetWithTwoFrontsIsValid) {
  tests::SceneSketch sketch;
  sketch.use("sheet", "paper");
  sketch.face(rectangle(0, 0, 4, 4, 0));
  sketch.use("sheet (twin)", "paper");
  sketch.face(reversed(rectangle(0, 0, 4, 4, 0)));
  sketch.use("box", "wood");
  sketch.box({1, 1, -3}, {2, 2, -2});
  for (const FacadeVerdict verdict : verdicts_on(sketch.take())) EXPECT_EQ(verdict, FacadeVerdict::ValidProved);
}

// The segment, on the lattice sixteen times as fine, against every triangle of the model.
void expect_free(const Context& context, const Facade& facade) {
  const auto fine = [](const geom::dvec3& p) {
    return LatticePoint{static_cast<std::int32_t>(std::lround(p.x * 16)),
                        static_cast<std::int32_t>(std::lround(p.y * 16)),
                        static_cast<std::int32_t>(std::lround(p.z * 16))};
  };
  const LatticePoint from = fine((*facade.sight)[0]), to = fine((*facade.sight)[1]);
  int meets = 0;
  for (const geom::LatticeTriangle& triangle : context.triangles.geometry) {
    std::array<LatticePoint, 3> corners = triangle.points;
    for (LatticePoint& p : corners) p = {16 * p.x, 16 * p.y, 16 * p.z};
    if (!geom::segment_meets_triangle(from, to, corners)) continue;
    ++meets;
    const auto lies_in = [&](const LatticePoint& end) {
      return geom::orient3d(corners[0], corners[1], corners[2], end) == geom::Sign::Zero;
    };
    EXPECT_TRUE(lies_in(from) || lies_in(to)) << "something is in the way";
  }
  EXPECT_EQ(meets, facade.from_open_space ? 1 : 2);
  const auto& normal = context.triangles.normal[facade.face];
  EXPECT_LT(glm::dot(normal, (*facade.sight)[0] - (*facade.sight)[1]), 0) << "it is not the back that is seen";
}

TEST(Facades, LinesOfSightAreFree) {
  std::size_t lines = 0;
  for (const Scene& scene : {box_over_slab(2 * kT), box_over_slab(1), room_with_poster(true, 0),
                             room_with_poster(false, 0.25), room_with_poster(false, 0)}) {
    const Context context = context_of(scene);
    for (const Facade& facade : facades_of(context).of_component) {
      if (facade.verdict != FacadeVerdict::InvalidProved) continue;
      expect_free(context, facade);
      ++lines;
    }
  }
  EXPECT_EQ(lines, 5U);
}

TEST(Facades, AreTheSameInAnyOrderAndForAnyNumberOfThreads) {
  for (const Scene& scene : {box_over_slab(2 * kT), room_with_poster(true, 0), room_with_poster(false, 0.25)}) {
    const Context context = context_of(scene);
    const Facades& expected = facades_of(context);
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + seed % 2);
      const Scene other = tests::rewritten(scene, seed);
      const Context shuffled = context_of(other);
      const Facades& found = facades_of(shuffled);
      ASSERT_EQ(found.of_component.size(), expected.of_component.size());
      for (std::size_t i = 0; i < found.of_component.size(); ++i) {
        EXPECT_EQ(found.of_component[i].verdict, expected.of_component[i].verdict);
        EXPECT_EQ(found.of_component[i].lit_back_area, expected.of_component[i].lit_back_area);
        EXPECT_TRUE(found.of_component[i].sight == expected.of_component[i].sight);
      }
    }
  }
}

// A closed model costs nothing; neither does one whose lamps stand in the open.
TEST(Facades, OfSolidsNeedNoCells) {
  tests::SceneSketch sketch;
  sketch.use("box", "wood");
  sketch.box({0, 0, 0}, {1, 1, 1});
  const Scene scene = sketch.take();
  const Context context = context_of(scene);
  EXPECT_EQ(facades_of(context).of_component.at(0).verdict, FacadeVerdict::NotAFacade);
  EXPECT_TRUE(facades_of(context).turned_over.empty());
}

}  // namespace
}  // namespace rad::validate
