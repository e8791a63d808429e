#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/generate/models.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

scene::Severity severity_of(const scene::Scene& scene, const char* rule, Stage stage, bool light = true) {
  LintOptions options;
  options.stage = stage;
  options.light = light;
  options.rules = {find_rule(rule)};
  const auto findings = lint(scene, {}, options).findings;
  EXPECT_EQ(findings.size(), 1u) << rule;
  return findings.at(0).severity;
}

TEST(GraveViolations, AreErrorsAtStageSolve) {
  const scene::Scene dark = corpus::clean_terrain(4);
  EXPECT_EQ(severity_of(dark, "RL402", Stage::Model), scene::Severity::Note);
  EXPECT_EQ(severity_of(dark, "RL402", Stage::Display), scene::Severity::Note);
  EXPECT_EQ(severity_of(dark, "RL402", Stage::Solve), scene::Severity::Error);
}

TEST(GraveViolations, AreNotWhereNoLightIsAskedFor) {
  EXPECT_EQ(severity_of(corpus::clean_terrain(4), "RL402", Stage::Solve, false), scene::Severity::Note);
}

TEST(GraveViolations, OnlyWhatHasNoSolution) {
  scene::Scene white = corpus::clean_terrain(4);
  for (scene::Material& material : white.materials) material.reflectance = geom::dvec3(0.97);
  EXPECT_EQ(severity_of(white, "RL401", Stage::Solve), scene::Severity::Warning);
  for (scene::Material& material : white.materials) material.reflectance = geom::dvec3(1);
  EXPECT_EQ(severity_of(white, "RL401", Stage::Solve), scene::Severity::Error);
  EXPECT_EQ(severity_of(white, "RL401", Stage::Model), scene::Severity::Warning);
}

}  // namespace
}  // namespace rad::validate
