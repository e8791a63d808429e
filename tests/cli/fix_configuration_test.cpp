// radfix under a configuration: what it reports follows it, what it decides and repairs does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "run.h"
#include "tests/report/schema_checker.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// Metres, and a pane of 0.02 mm.
const std::string kBoxAndPane = "o box\n" + kBoxWithFlippedFace +
                                "o pane\nv 3 0 0\nv 7 0 0\nv 7 3 0\nv 3 3 0\n"
                                "v 3 0 0.00002\nv 7 0 0.00002\nv 7 3 0.00002\nv 3 3 0.00002\n"
                                "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";

class FixConfiguration : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("a.obj", kBoxAndPane);
  }

  Outcome fix(std::vector<std::string> more = {}) const {
    std::vector<std::string> args{at("a.obj"), "-o", at("fixed.obj"), "--report", "json=" + at("fix.json")};
    args.insert(args.end(), more.begin(), more.end());
    return outcome_of(&run_radfix, args);
  }
  json report(const std::vector<std::string>& more = {}) const {
    EXPECT_EQ(fix(more).err, "");
    json it = json::parse(read("fix.json"));
    EXPECT_THAT(report::SchemaChecker("repair_report.schema.json").faults(it), testing::IsEmpty());
    return it;
  }
  static std::string severity_of(const json& summary, const std::string& rule) {
    return summary["byRule"].contains(rule) ? summary["byRule"][rule]["severity"] : "none";
  }
};

TEST_F(FixConfiguration, WithoutAnyEverythingIsAsUsual) {
  const json it = report();
  EXPECT_EQ(severity_of(it["before"], "RL110"), "error");
  EXPECT_EQ(severity_of(it["after"], "RL501"), "warning");
  EXPECT_TRUE(it["inputs"][0]["configuration"].is_null());
}

TEST_F(FixConfiguration, BothVerdictsFollowIt) {
  write("radlint.toml", "units = \"mm\"\ntolerance = \"0.05\"\n[rules.RL110]\nseverity = \"note\"\n");
  const json it = report();
  EXPECT_EQ(severity_of(it["before"], "RL110"), "note");
  EXPECT_EQ(severity_of(it["before"], "RL501"), "none");
  EXPECT_EQ(severity_of(it["after"], "RL501"), "none");
  EXPECT_EQ(severity_of(it["after"], "RL110"), "none") << "repaired all the same";
  EXPECT_NEAR(it["tolerance"]["T"], 0.05, 0.001);
  EXPECT_EQ(it["tolerance"]["source"], "given");
  for (const char* side : {"inputs", "outputs"}) {
    EXPECT_THAT(std::string(it[side][0]["configuration"]), HasSubstr("radlint.toml")) << side;
  }
  const json isolated = report({"--isolated"});
  EXPECT_EQ(severity_of(isolated["before"], "RL110"), "error");
  write("other.toml", "[rules.RL110]\nseverity = \"warning\"\n");
  EXPECT_EQ(severity_of(report({"--config", at("other.toml")})["before"], "RL110"), "warning");
  EXPECT_NEAR(report({"--tolerance", "0.02"})["tolerance"]["T"], 0.02, 0.001) << "the command line stands above";
}

TEST_F(FixConfiguration, WhatIsAskedOfTheWholeFileHoldsForTheResult) {
  write("a.obj", "# radlint: ignore-file[RL501] scan\n# radlint: ignore-file[RL402] nothing is lit\n" + kBoxAndPane);
  write("a.obj.radlint.toml", "[[suppress]]\nrules = [\"RL505\"]\nreason = \"known\"\n");
  const json it = report();
  for (const char* rule : {"RL501", "RL402", "RL505", "RL903"}) {
    EXPECT_EQ(severity_of(it["before"], rule), "none") << rule;
    EXPECT_EQ(severity_of(it["after"], rule), "none") << rule;
  }
  EXPECT_EQ(it["after"]["suppressed"], 3);
}

TEST_F(FixConfiguration, WhatIsCuredLeavesNoUnusedSuppression) {
  write("a.obj", "# radlint: ignore-file[RL110] export\n" + kBoxAndPane);
  const json it = report();
  EXPECT_EQ(it["before"]["suppressed"], 1);
  EXPECT_EQ(it["after"]["suppressed"], 0) << "what is silenced is repaired as well";
  EXPECT_EQ(severity_of(it["after"], "RL903"), "none");
}

TEST_F(FixConfiguration, ObjectsByNameHoldForTheResult) {
  write("a.obj", "o sheet\n" + kSquare);
  EXPECT_EQ(severity_of(report()["after"], "RL101"), "note");
  write("radlint.toml", "[[objects]]\nobjects = [\"sheet\"]\nignore = [\"RL101\"]\nreason = \"a facade\"\n");
  const json it = report();
  EXPECT_EQ(severity_of(it["after"], "RL101"), "none");
  EXPECT_EQ(it["after"]["suppressed"], 1);
}

TEST_F(FixConfiguration, ThinFeaturesAreAlwaysListed) {
  ASSERT_FALSE(report()["thinFeatures"].empty());
  write("radlint.toml", "ignore = [\"RL107\"]\n");
  EXPECT_FALSE(report()["thinFeatures"].empty());
  write("radlint.toml", "[rules.RL107]\nseverity = \"off\"\n");
  EXPECT_FALSE(report()["thinFeatures"].empty());
  write("radlint.toml", "");
  write("a.obj.radlint.toml", "[[suppress]]\nrules = [\"RL107\"]\n");
  EXPECT_FALSE(report()["thinFeatures"].empty());
}

TEST_F(FixConfiguration, FacesAreNotLostForWantOfARule) {
  write("a.obj", kBox + "f 1 2 99\n");
  write("radlint.toml", "ignore = [\"RL002\"]\n");
  const Outcome outcome = fix();
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("RL002"));
}

TEST_F(FixConfiguration, RulesThatAreCuredTogetherAreNamedWhateverIsIgnored) {
  write("radlint.toml", "ignore = [\"RL110\"]\n");
  write("a.obj", kBoxWithFlippedFace + "v 0.5 0 0\nv 0.5 -1 0\nv 0 -1 0\nf 1 9 10 11\n");
  const Outcome plain = fix({"--fix-only", "RL110", "--isolated"});
  const Outcome ignored = fix({"--fix-only", "RL110"});
  EXPECT_EQ(plain.exit_code, ignored.exit_code);
  EXPECT_EQ(plain.err, ignored.err);
}

TEST_F(FixConfiguration, FaultsAreUsageErrors) {
  write("radlint.toml", "tolerence = \"0.1\"\n");
  const Outcome outcome = fix();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("radfix: "));
  EXPECT_THAT(outcome.err, HasSubstr("tolerance"));
  EXPECT_EQ(fix({"--isolated"}).exit_code, 0);
  EXPECT_EQ(fix({"--isolated", "--config", at("radlint.toml")}).exit_code, 2);
}

}  // namespace
}  // namespace rad::cli
