#include "validate/parameter.h"

#include <gtest/gtest.h>

#include "corpus/generate/models.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

const Rule& poor_shape() { return *find_rule("RL240"); }

TEST(ParameterValues, StandardUntilSet) {
  ParameterValues values;
  EXPECT_EQ(values.of(poor_shape(), "min-shape"), 0.20);
  EXPECT_EQ(values.set(poor_shape(), "min-shape", 0.5), "");
  EXPECT_EQ(values.of(poor_shape(), "min-shape"), 0.5);
}

TEST(ParameterValues, RefusesWhatItCannotUse) {
  ParameterValues values;
  EXPECT_EQ(values.set(poor_shape(), "min-shap", 0.5), "RL240 has no parameter min-shap; did you mean min-shape?");
  EXPECT_EQ(values.set(*find_rule("RL001"), "min-shape", 0.5), "RL001 has no parameters");
  EXPECT_EQ(values.set(poor_shape(), "min-shape", 1.5), "min-shape of RL240 lies between 0 and 1");
  EXPECT_NE(values.set(poor_shape(), "min-shape", std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(values, ParameterValues{});
}

TEST(ParameterValues, ReachTheCheckAndTheThresholdOfTheFinding) {
  LintOptions options;
  options.rules = {&poor_shape()};
  const scene::Scene terrain = corpus::clean_terrain(8);
  ASSERT_TRUE(lint(terrain, {}, options).findings.empty());
  ASSERT_EQ(options.parameters.set(poor_shape(), "min-shape", 1), "");
  const auto findings = lint(terrain, {}, options).findings;
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings.front().measure->threshold, 1);
}

}  // namespace
}  // namespace rad::validate
