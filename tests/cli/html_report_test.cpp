#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/radlint.h"
#include "tests/cli/run.h"

namespace rad::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kModel = std::string(RAD_SOURCE_DIR) + "/corpus/rules/RL201-t-vertex/fail.obj";

TEST(HtmlReport, ShowsTheModel) {
  const Outcome outcome = outcome_of(run_radlint, {kModel, "--format", "html"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("<!doctype html>"));
  EXPECT_THAT(outcome.out, HasSubstr("class=\"geometry\""));
}

TEST(HtmlReport, OfWhatCannotBeRead_HasNoModel) {
  const std::string torn = std::string(RAD_SOURCE_DIR) + "/corpus/rules/RL001-parse-error/fail_4.skp";
  const Outcome outcome = outcome_of(run_radlint, {torn, "--format", "html"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("RL001"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("class=\"geometry\"")));
}

TEST(HtmlReport, DoesNotHangOnTheNumberOfThreads) {
  const std::string one = outcome_of(run_radlint, {kModel, "--format", "html", "-j1"}).out;
  EXPECT_EQ(outcome_of(run_radlint, {kModel, "--format", "html", "-j2"}).out, one);
}

}  // namespace
}  // namespace rad::cli
