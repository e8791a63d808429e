// Facades through repair: what stands on a floor is shut off by it, what hangs over it is not; rooms stay rooms.
#include <gtest/gtest.h>

#include <algorithm>

#include "repair/orientation.h"
#include "repair/planar_caps.h"
#include "repair/two_sided.h"
#include "scene/twins.h"
#include "tests/support/derived_scene.h"
#include "tests/support/repaired_checks.h"
#include "validate/rules.h"

namespace rad::repair {
namespace {

using scene::dvec3;
using scene::FaceId;
using scene::Scene;
using validate::FacadeVerdict;

constexpr double kTolerance = 1.0 / 64;
const geom::ToleranceRequest kRequest{kTolerance, geom::ToleranceRequest::Measure::FileUnits};
const scene::ReadIssues kNoIssues;

using Verdicts = std::vector<FacadeVerdict>;

Scene repaired_scene(const Scene& scene) {
  return scene::repaired_scene(tests::repaired(scene, kTolerance).model, scene, scene::Pieces::Triangles);
}

Verdicts verdicts_on(const Scene& scene) {
  std::string refusal;
  const auto context = validate::build_context(scene, kNoIssues, kRequest, refusal);
  Verdicts verdicts;
  for (std::size_t i = 0; i < context->topology.components.size(); ++i) {
    if (context->topology.components[i].open_subedges == 0) continue;
    verdicts.push_back(validate::facades_of(*context).of_component[i].verdict);
  }
  return verdicts;
}

std::size_t findings_of(const Scene& scene, const validate::Rule& rule) {
  validate::LintOptions options;
  options.rules = {&rule};
  options.tolerance = kRequest;
  return validate::lint(scene, kNoIssues, options).findings.size();
}

Scene with_light(Scene scene, const std::string& material) {
  for (scene::Material& m : scene.materials) {
    if (m.name == material) m.emission = {100, 100, 100};
  }
  return scene;
}

Scene box_over_slab(double height) {
  tests::SceneSketch sketch;
  sketch.use("slab", "stone");
  sketch.box({0, 0, -1}, {12, 12, 0});
  sketch.use("box", "wood");
  sketch.box({4, 4, height}, {8, 8, 4}, 4);
  return sketch.take();
}

TEST(FacadeRepair, ABoxOnAFloorIsShutOff) {
  for (const double height : {0.0, 0.5 * kTolerance, -0.5 * kTolerance, -0.25}) {
    const Scene repaired = repaired_scene(box_over_slab(height));
    const Verdicts verdicts = verdicts_on(repaired);
    EXPECT_FALSE(verdicts.empty()) << height;
    for (const FacadeVerdict verdict : verdicts) EXPECT_EQ(verdict, FacadeVerdict::ValidProved) << height;
    EXPECT_EQ(findings_of(repaired, validate::invalid_facade), 0U);
  }
}

TEST(FacadeRepair, ABoxOverAFloorIsSeenFromBelow) {
  for (const double height : {2 * kTolerance, 1.0}) {
    const Scene repaired = repaired_scene(box_over_slab(height));
    EXPECT_EQ(verdicts_on(repaired), (Verdicts{FacadeVerdict::InvalidProved})) << height;
    EXPECT_EQ(findings_of(repaired, validate::invalid_facade), 1U);
  }
}

// Rooms within a building, all of inward sheets, joined by a door; lamps in both.
Scene two_rooms() {
  tests::SceneSketch sketch;
  sketch.use("west", "wall");
  sketch.box({0, 0, 0}, {6, 6, 3});
  sketch.use("east", "wall");
  sketch.box({7, 0, 0}, {13, 6, 3});
  Scene scene = sketch.take();
  std::vector<FaceId> all;
  for (FaceId face = 0; face < scene.faces.size(); ++face) all.push_back(face);
  return turned(std::move(scene), all);
}

TEST(FacadeRepair, ARoomWithALampIsNotTurned) {
  tests::SceneSketch sketch;
  sketch.use("room", "wall");
  sketch.box({0, 0, 0}, {6, 6, 3});
  sketch.use("lamp", "lamp");
  sketch.box({2, 2, 2}, {3, 3, 2.5});
  const Scene scene = with_light(turned(sketch.take(), {0, 1, 2, 3, 4, 5}), "lamp");
  Scene once = scene;
  EXPECT_TRUE(orient(once, kNoIssues, kRequest).turned.empty());
}

TEST(FacadeRepair, ARoomThatWasDrawnOutwardAroundItsLampIsTurned) {
  tests::SceneSketch sketch;
  sketch.use("room", "wall");
  sketch.box({0, 0, 0}, {6, 6, 3});
  sketch.use("lamp", "lamp");
  sketch.box({2, 2, 2}, {3, 3, 2.5});
  Scene scene = with_light(sketch.take(), "lamp");
  EXPECT_EQ(findings_of(scene, validate::facade_facing_away), 1U);
  EXPECT_EQ(orient(scene, kNoIssues, kRequest).turned, (std::vector<FaceId>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(findings_of(scene, validate::facade_facing_away), 0U);
}

TEST(FacadeRepair, EmptyDarkRoomsAreJudgedAsBefore) {
  Scene scene = two_rooms();
  EXPECT_EQ(orient(scene, kNoIssues, kRequest).turned.size(), 12U);
}

// A solid that is lit from both sides is not turned: nothing is proved.
TEST(FacadeRepair, WhatIsLitFromBothSidesIsLeft) {
  tests::SceneSketch sketch;
  sketch.use("glass", "wall");
  sketch.box({0, 0, 0}, {6, 6, 3});
  sketch.use("bulb", "lamp");
  sketch.box({2, 2, 1}, {3, 3, 2});
  sketch.use("street lamp", "lamp");
  sketch.box({20, 2, 1}, {21, 3, 2});
  Scene scene = with_light(sketch.take(), "lamp");
  EXPECT_TRUE(orient(scene, kNoIssues, kRequest).turned.empty());
}

Scene sheet_over_box() {
  tests::SceneSketch sketch;
  sketch.use("sheet", "paper");
  sketch.face({{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  sketch.use("box", "wood");
  sketch.box({1, 1, -2}, {2, 2, -1});
  return sketch.take();
}

TEST(TwoSided, ASheetGetsATwin) {
  const std::vector<std::string> patterns{"she*"};
  const Doubled doubled = with_twins(sheet_over_box(), patterns);
  EXPECT_EQ(doubled.twins, 1U);
  EXPECT_EQ(doubled.unmatched, "");
  EXPECT_EQ(doubled.scene.objects.back(), scene::twin_name("sheet"));
  EXPECT_EQ(doubled.scene.faces.back().material, doubled.scene.faces.front().material);
  EXPECT_EQ(with_twins(doubled.scene, patterns).twins, 0U) << "twice is once";
  EXPECT_EQ(verdicts_on(sheet_over_box()), (Verdicts{FacadeVerdict::InvalidProved}));
  const Scene repaired = repaired_scene(doubled.scene);
  for (const FacadeVerdict verdict : verdicts_on(repaired)) EXPECT_EQ(verdict, FacadeVerdict::ValidProved);
  EXPECT_EQ(findings_of(repaired, validate::double_sided_duplicate), 0U);
  EXPECT_EQ(findings_of(repaired, validate::hidden_coplanar), 0U);
  EXPECT_EQ(tests::errors_in(tests::repaired(doubled.scene, kTolerance).model, doubled.scene),
            std::vector<std::string>{});
}

TEST(TwoSided, PatternsNameObjectsAndMaterials) {
  EXPECT_EQ(with_twins(sheet_over_box(), std::vector<std::string>{"wood"}).twins, 6U);
  EXPECT_EQ(with_twins(sheet_over_box(), std::vector<std::string>{"paper", "b?x"}).twins, 7U);
  const Doubled none = with_twins(sheet_over_box(), std::vector<std::string>{"paper", "brick"});
  EXPECT_EQ(none.unmatched, "brick");
  EXPECT_EQ(none.twins, 0U);
}

TEST(PlanarCaps, CloseABox) {
  for (int side = 0; side < 6; ++side) {
    tests::SceneSketch sketch;
    sketch.box({0, 0, 0}, {3, 2, 1}, side);
    const Capped capped = with_planar_caps(sketch.take(), kNoIssues, kRequest);
    EXPECT_EQ(capped.caps, 1U);
    EXPECT_EQ(findings_of(capped.scene, validate::open_boundary), 0U);
    EXPECT_EQ(findings_of(capped.scene, validate::normal_inconsistent), 0U);
    EXPECT_EQ(findings_of(capped.scene, validate::inside_out_solid), 0U);
    EXPECT_EQ(with_planar_caps(capped.scene, kNoIssues, kRequest).caps, 0U);
  }
}

// A tube with thick walls, open at both ends: each cap is a ring.
TEST(PlanarCaps, CloseARing) {
  tests::SceneSketch sketch;
  const auto wall = [&](double low, double high, bool inward) {
    const std::vector<dvec3> ring{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec3 a = ring[i], b = ring[(i + 1) % 4], up(0, 0, 5);
      sketch.face(inward ? std::vector<dvec3>{b, a, a + up, b + up} : std::vector<dvec3>{a, b, b + up, a + up});
    }
  };
  wall(0, 9, false);
  wall(3, 6, true);
  const Capped two_shells = with_planar_caps(sketch.take(), kNoIssues, kRequest);
  EXPECT_EQ(two_shells.caps, 4U) << "two shells that nothing joins are two tubes";
}

TEST(PlanarCaps, CloseAHoleInASheetButNotTheSheet) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
  sketch.hole({{2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}});
  const Capped capped = with_planar_caps(sketch.take(), kNoIssues, kRequest);
  EXPECT_EQ(capped.caps, 1U);
  EXPECT_EQ(findings_of(capped.scene, validate::coplanar_overlap_same), 0U);
  EXPECT_EQ(findings_of(capped.scene, validate::normal_inconsistent), 0U);
}

TEST(PlanarCaps, LeaveACurvedOpening) {
  tests::SceneSketch sketch;
  const dvec3 top(2, 2, 6);
  const std::vector<dvec3> rim{{0, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 1}};
  for (std::size_t i = 0; i < 4; ++i) sketch.face({rim[i], rim[(i + 1) % 4], top});
  EXPECT_EQ(with_planar_caps(sketch.take(), kNoIssues, kRequest).caps, 0U);
}

}  // namespace
}  // namespace rad::repair
