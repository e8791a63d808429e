// Thin features: what is one, what is none, and what keeps it.
#include "validate/thin_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/support/derived_scene.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_variants.h"
#include "validate/lint.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

using scene::dvec3;

constexpr double kTolerance = 1.0 / 64;

std::vector<scene::Finding> findings_at(const scene::Scene& scene, double tolerance) {
  LintOptions options;
  options.rules = {&thin_feature};
  options.tolerance = geom::ToleranceRequest{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  return lint(scene, {}, options).findings;
}

std::vector<ThinFeature> features_of(const scene::Scene& scene) {
  std::string refusal;
  const geom::ToleranceRequest request{kTolerance, geom::ToleranceRequest::Measure::FileUnits};
  return find_thin_features(build_context(scene, {}, request, refusal).value());
}

std::size_t count_of(const std::vector<ThinFeature>& features, ThinKind kind) {
  return static_cast<std::size_t>(std::ranges::count(features, kind, &ThinFeature::kind));
}

scene::Scene pane(double thickness) {
  tests::SceneSketch sketch;
  sketch.use("pane", "glass");
  sketch.box({0, 0, 0}, {4, thickness, 3});
  return sketch.take();
}

TEST(ThinFeatures, FindThePaneUpToTheWeldDistance) {
  for (const double share : {0.1, 0.5, 0.9, 1.0, 1.1, 1.15}) {
    const auto features = features_of(pane(share * kTolerance));
    EXPECT_EQ(count_of(features, ThinKind::Plate), 1u) << share;
    const auto plate = std::ranges::find(features, ThinKind::Plate, &ThinFeature::kind);
    EXPECT_NEAR(plate->thickness, share * 32768, 1) << share;  // T is 2^15 pitches
  }
  for (const double share : {1.18, 1.5, 3.0}) {
    EXPECT_EQ(count_of(features_of(pane(share * kTolerance)), ThinKind::Plate), 0u) << share;
  }
}

TEST(ThinFeatures, FindTheRimUpToTwiceT) {
  EXPECT_EQ(count_of(features_of(pane(1.9 * kTolerance)), ThinKind::Strip), 4u);
  EXPECT_EQ(count_of(features_of(pane(2.1 * kTolerance)), ThinKind::Strip), 0u);
}

// A pane stays one though it has no rim. Where both sides look one way they are an overlap (RL220).
TEST(ThinFeatures, FindThePaneWithoutARim) {
  const double y = kTolerance / 2;
  for (const bool opposite : {true, false}) {
    tests::SceneSketch sketch;
    sketch.use("pane", "glass");
    sketch.face({{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}});
    std::vector<dvec3> back{{0, y, 0}, {0, y, 3}, {4, y, 3}, {4, y, 0}};
    if (!opposite) std::reverse(back.begin(), back.end());
    sketch.face(back);
    EXPECT_EQ(count_of(features_of(sketch.take()), ThinKind::Plate), opposite ? 1u : 0u);
  }
}

// In whatever direction it looks: the search parts the triangles by their directions.
TEST(ThinFeatures, FindThePaneInAnyDirection) {
  tests::LatticeRandom random(11);
  for (int i = 0; i < 200; ++i) {
    const auto part = [&] { return static_cast<double>(random.between(-50, 50)); };
    const dvec3 normal = i < 40 ? glm::cross(dvec3(0.5306, 0.6118, 0.5866), dvec3(part(), part(), part() + 0.5))
                                : dvec3(part(), part(), part() + 0.5);
    const dvec3 up = glm::normalize(normal);
    const dvec3 u = glm::normalize(glm::cross(up, dvec3(0.3, 0.2, 0.9))), v = glm::cross(up, u);
    const dvec3 off = up * (kTolerance / 2);
    tests::SceneSketch sketch;
    sketch.face({-u - v, u - v, u + v, v - u});
    sketch.face({off - u - v, off + v - u, off + u + v, off + u - v});
    const auto features = features_of(sketch.take());
    EXPECT_GE(count_of(features, ThinKind::Plate) + count_of(features, ThinKind::Slit), 1u) << i;
  }
}

TEST(ThinFeatures, AreNotWhereSolidsTouch) {
  for (const double gap : {-0.5, 0.0, 0.5}) {
    for (const char* other : {"left", "right"}) {
      tests::SceneSketch sketch;
      sketch.use("left", "stone");
      sketch.box({0, 0, 0}, {2, 2, 2});
      sketch.use(other, "stone");
      sketch.box({2 + gap * kTolerance, 0, 0}, {4, 2, 2});
      EXPECT_TRUE(features_of(sketch.take()).empty()) << gap << ' ' << other;
    }
  }
}

// A needle among the triangles of a plane is no feature of it.
TEST(ThinFeatures, AreNotTheNeedlesOfAPlane) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {4, 0, 0}, {4, 1.5 * kTolerance, 0}});
  sketch.face({{0, 0, 0}, {4, 1.5 * kTolerance, 0}, {4, 3, 0}, {0, 3, 0}});
  EXPECT_TRUE(features_of(sketch.take()).empty());
}

TEST(ThinFeatures, AreKeptByTheToleranceThatTheFindingNames) {
  std::size_t advised = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    const double thickness = static_cast<double>(random.between(1, 200)) / 100 * kTolerance;
    const scene::Scene scene = pane(thickness);
    for (const scene::Finding& finding : findings_at(scene, kTolerance)) {
      ASSERT_TRUE(finding.kept_below.has_value());
      if (*finding.kept_below == 0) continue;
      EXPECT_LT(*finding.kept_below, kTolerance);
      ++advised;
    }
    double least = kTolerance;
    for (const scene::Finding& finding : findings_at(scene, kTolerance)) {
      least = std::min(least, *finding.kept_below);
    }
    if (least == 0) continue;
    EXPECT_TRUE(findings_at(scene, least).empty()) << least;
  }
  EXPECT_GT(advised, 60u);
}

TEST(ThinFeatures, ComeAsTwoFindingsForABlind) {
  tests::SceneSketch sketch;
  sketch.use("blind", "steel");
  for (int i = 0; i < 40; ++i) sketch.box({0, 0.1 * i, 0}, {3, 0.1 * i + 0.8 * kTolerance, 0.08});
  const auto findings = findings_at(sketch.take(), kTolerance);
  ASSERT_EQ(findings.size(), 2u);
  for (const scene::Finding& finding : findings) {
    const bool plates = finding.message.starts_with("plate");
    EXPECT_EQ(finding.count, plates ? 40u : 160u) << finding.message;  // all of the rims are strips
    EXPECT_NEAR(finding.area.value_or(0), plates ? 40 * 3 * 0.08 : 40 * 6.16 * 0.8 * kTolerance, 0.01);
  }
}

}  // namespace
}  // namespace rad::validate
