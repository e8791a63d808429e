// Configuration and suppressions as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cli/radlint.h"
#include "run.h"
#include "tests/report/schema_checker.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Configuration : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("a.obj", "o box\n" + kBoxWithFlippedFace);
  }

  Outcome radlint(std::vector<std::string> args) const { return outcome_of(&run_radlint, args); }
  Outcome lint(std::vector<std::string> more = {}) const {
    std::vector<std::string> args{at("a.obj"), "--format", "json"};
    args.insert(args.end(), more.begin(), more.end());
    return radlint(args);
  }
  json report(const std::vector<std::string>& more = {}) const {
    const Outcome outcome = lint(more);
    EXPECT_EQ(outcome.err, "");
    json it = json::parse(outcome.out);
    EXPECT_THAT(report::SchemaChecker("report.schema.json").faults(it), testing::IsEmpty());
    return it;
  }
  static std::string severity_of(const json& report, const std::string& rule) {
    return report["summary"]["byRule"].contains(rule) ? report["summary"]["byRule"][rule]["severity"] : "none";
  }
};

TEST_F(Configuration, WithoutAnyEverythingIsAsUsual) {
  const json it = report();
  EXPECT_EQ(severity_of(it, "RL110"), "error");
  EXPECT_TRUE(it["inputs"][0]["configuration"].is_null());
  EXPECT_EQ(it["summary"]["suppressed"], 0);
  EXPECT_EQ(lint().exit_code, 1);
}

TEST_F(Configuration, SeverityOfTheFileAndOfTheCommandLine) {
  write("radlint.toml", "[rules.RL110]\nseverity = \"warning\"\n");
  EXPECT_EQ(severity_of(report(), "RL110"), "warning");
  EXPECT_EQ(lint().exit_code, 0);
  EXPECT_EQ(severity_of(report({"--severity", "normal-inconsistent=note"}), "RL110"), "note");
  EXPECT_EQ(severity_of(report({"--severity", "RL110=off"}), "RL110"), "none");
  EXPECT_EQ(severity_of(report({"--isolated"}), "RL110"), "error");
  EXPECT_THAT(std::string(report()["inputs"][0]["configuration"]), HasSubstr("radlint.toml"));
}

TEST_F(Configuration, RulesOfTheFileAndOfTheCommandLine) {
  write("radlint.toml", "select = [\"RL1\"]\nignore = [\"RL110\"]\n");
  const auto checked = [&](const std::vector<std::string>& more) {
    std::vector<std::string> rules = report(more)["summary"]["checkedRules"];
    return std::set<std::string>(rules.begin(), rules.end());
  };
  EXPECT_FALSE(checked({}).contains("RL110"));
  EXPECT_FALSE(checked({}).contains("RL201"));
  EXPECT_TRUE(checked({"--extend-select", "RL201"}).contains("RL201"));
  EXPECT_TRUE(checked({"--extend-select", "RL110"}).contains("RL110"));
  EXPECT_FALSE(checked({"--extend-ignore", "RL101"}).contains("RL101"));
  EXPECT_TRUE(checked({"--ignore", "RL101"}).contains("RL110"));
  EXPECT_EQ(checked({"--select", "RL201"}), std::set<std::string>{"RL201"});
}

TEST_F(Configuration, UnitsToleranceStageAndFailOn) {
  write("radlint.toml", "units = \"mm\"\nup = \"y\"\ntolerance = \"0.1mm\"\nstage = \"solve\"\nfail-on = \"never\"\n");
  const json it = report();
  EXPECT_EQ(it["inputs"][0]["units"]["value"], "mm");
  EXPECT_EQ(it["inputs"][0]["up"]["value"], "y");
  EXPECT_NEAR(double(it["tolerance"]["T"]), 0.1, 0.01);
  EXPECT_EQ(it["invocation"]["stage"], "solve");
  EXPECT_EQ(it["invocation"]["failOn"], "never");
  EXPECT_EQ(lint().exit_code, 0);
  const json said =
      report({"--units", "cm", "--up", "z", "--tolerance", "0.01", "--stage", "display", "--fail-on", "error"});
  EXPECT_EQ(said["inputs"][0]["units"]["value"], "cm");
  EXPECT_EQ(said["inputs"][0]["up"]["value"], "z");
  EXPECT_NEAR(double(said["tolerance"]["T"]), 0.01, 0.001);
  EXPECT_EQ(said["invocation"]["stage"], "display");
  EXPECT_EQ(said["invocation"]["failOn"], "error");
}

TEST_F(Configuration, ThresholdsReachTheRules) {
  EXPECT_EQ(severity_of(report(), "RL240"), "none");
  write("radlint.toml", "[rules.RL502]\nmin-size = 100\n");
  const json it = report({"--units", "m", "--select", "RL502"});
  EXPECT_NE(severity_of(it, "RL502"), "none");
  EXPECT_EQ(severity_of(report({"--units", "m", "--select", "RL502", "--isolated"}), "RL502"), "none");
}

TEST_F(Configuration, FaultsAreUsageErrorsWithPlaceAndSuggestion) {
  write("radlint.toml", "\nselct = [\"RL2\"]\n");
  const Outcome outcome = lint();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, testing::EndsWith("radlint.toml:2: unknown key 'selct'; did you mean select?\n"));
  EXPECT_EQ(lint({"--isolated"}).exit_code, 1);
  write("good.toml", "ignore = [\"RL110\"]\n");
  EXPECT_EQ(lint({"--config", at("good.toml")}).exit_code, 0);
  EXPECT_EQ(lint({"--config", at("none.toml")}).exit_code, 2);
  EXPECT_EQ(lint({"--config", at("good.toml"), "--isolated"}).exit_code, 2);
  EXPECT_EQ(lint({"--severity", "RL110"}).exit_code, 2);
  EXPECT_EQ(lint({"--severity", "RL110=mild"}).exit_code, 2);
  EXPECT_EQ(lint({"--severity", "RL11x=note"}).exit_code, 2);
  EXPECT_EQ(lint({"--extend-select", "RL11x"}).exit_code, 2);
  EXPECT_THAT(lint({"--isolated", "--select", "RL110", "--extend-ignore", "RL110"}).err, HasSubstr("leave no rule"));
  write("radlint.toml", "select = [\"RL110\"]\n");
  EXPECT_THAT(lint({"--extend-ignore", "RL110"}).err, HasSubstr("a.obj: no rule is left to check"));
}

TEST_F(Configuration, FilesHaveSettingsOfTheirOwn) {
  write("radlint.toml", "[[files]]\nfiles = \"sub/*.obj\"\nignore = [\"RL110\"]\nunits = \"ft\"\n");
  write("sub/b.obj", kBoxWithFlippedFace);
  const json it = json::parse(radlint({at(""), "--format", "json"}).out);
  ASSERT_EQ(it["inputs"].size(), 2U);
  for (const json& input : it["inputs"]) {
    const bool sub = std::string(input["path"]).ends_with("b.obj");
    EXPECT_EQ(input["units"]["value"].is_null(), !sub);
    EXPECT_EQ(input["summary"]["errors"], sub ? 0 : 1);
  }
}

TEST_F(Configuration, FoldersAreSearchedAsConfigured) {
  write("radlint.toml", "exclude = [\"legacy\", \"x/*.obj\", \"*.stl\"]\n");
  write("legacy/b.obj", kBox);
  write("x/c.obj", kBox);
  write("x/d.stl", "solid x\nendsolid x\n");
  const json it = json::parse(radlint({at(""), "--format", "json"}).out);
  EXPECT_EQ(it["inputs"].size(), 1U);
  EXPECT_EQ(json::parse(radlint({at("legacy/b.obj"), "--format", "json"}).out)["inputs"].size(), 1U);
}

TEST_F(Configuration, OneRunHasOneStage) {
  write("x/radlint.toml", "stage = \"solve\"\n");
  write("x/b.obj", kBox);
  const Outcome outcome = radlint({at("a.obj"), at("x/b.obj")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("b.obj"), HasSubstr("solve"), HasSubstr("--stage")));
  EXPECT_EQ(radlint({at("a.obj"), at("x/b.obj"), "--stage", "model"}).exit_code, 1);
}

TEST_F(Configuration, ObjectsAreTreatedByName) {
  write("radlint.toml", "[[objects]]\nobjects = \"bo?\"\nignore = [\"RL110\"]\nreason = \"as built\"\n");
  const json it = report();
  EXPECT_EQ(severity_of(it, "RL110"), "none");
  EXPECT_EQ(it["summary"]["suppressed"], 1);
  const json& use = it["inputs"][0]["suppressions"].at(0);
  EXPECT_EQ(use["origin"], "configuration");
  EXPECT_EQ(use["reason"], "as built");
  EXPECT_EQ(use["line"], 1);
  write("radlint.toml", "[[objects]]\nobjects = \"box\"\nrules = { RL110 = \"note\" }\n");
  EXPECT_EQ(severity_of(report(), "RL110"), "note");
  write("radlint.toml", "[[objects]]\nobjects = \"b\"\nignore = [\"RL110\"]\n");
  EXPECT_EQ(severity_of(report(), "RL110"), "error");
}

TEST_F(Configuration, CommentsAndSidecarsSuppress) {
  write("a.obj", "# radlint: ignore[RL110] as built\no box\n" + kBoxWithFlippedFace);
  json it = report();
  EXPECT_EQ(severity_of(it, "RL110"), "none");
  EXPECT_EQ(it["inputs"][0]["suppressions"][0]["origin"], "comment");
  EXPECT_EQ(severity_of(it, "RL903"), "none");
  write("a.obj", "o box\n" + kBoxWithFlippedFace);
  write("a.obj.radlint.toml", "[[suppress]]\nrules = [\"RL110\", \"RL221\"]\nobjects = [\"box\"]\n");
  it = report();
  EXPECT_EQ(severity_of(it, "RL110"), "none");
  EXPECT_EQ(it["inputs"][0]["suppressions"][0]["origin"], "sidecar");
  EXPECT_EQ(severity_of(it, "RL903"), "warning");
  EXPECT_THAT(radlint({at("a.obj")}).out, HasSubstr("1 finding is suppressed and not listed"));
  write("a.obj.radlint.toml", "[[suppress]]\nrule = [\"RL110\"]\n");
  it = report();
  EXPECT_EQ(severity_of(it, "RL905"), "warning");
  EXPECT_EQ(severity_of(it, "RL110"), "error");
  EXPECT_EQ(severity_of(report({"--severity", "RL905=error"}), "RL905"), "error");
}

TEST_F(Configuration, SarifKeepsWhatIsSuppressed) {
  write("a.obj", "# radlint: ignore[RL110] as built\no box\n" + kBoxWithFlippedFace);
  const json run = json::parse(radlint({at("a.obj"), "--format", "sarif"}).out)["runs"][0];
  std::size_t suppressed = 0;
  for (const json& result : run["results"]) {
    ASSERT_TRUE(result.contains("suppressions"));
    if (result["suppressions"].empty()) continue;
    ++suppressed;
    EXPECT_EQ(result["ruleId"], "RL110");
    EXPECT_EQ(result["suppressions"][0]["kind"], "inSource");
    EXPECT_EQ(result["suppressions"][0]["justification"], "as built");
  }
  EXPECT_EQ(suppressed, 1U);
}

TEST_F(Configuration, SarifOfReportsIsThatOfTheRun) {
  write("a.obj", "# radlint: ignore[RL110] as built\no box\n" + kBoxWithFlippedFace);
  write("b.obj", kBoxWithFlippedFace);
  write("b.obj.radlint.toml", "[[suppress]]\nrules = [\"RL110\"]\n");
  radlint({at("a.obj"), "--no-group", "--report", "json=" + at("a.json"), "-q"});
  radlint({at("b.obj"), "--no-group", "--report", "json=" + at("b.json"), "-q"});
  const std::string run = radlint({at("a.obj"), at("b.obj"), "--no-group", "--format", "sarif"}).out;
  EXPECT_EQ(radlint({"merge", at("a.json"), at("b.json"), "--format", "sarif"}).out, run);
  const json report = json::parse(read("b.json"));
  EXPECT_EQ(report["suppressed"].size(), 4U);
  EXPECT_EQ(report["suppressed"][0]["finding"]["rule"], "RL110");
  EXPECT_EQ(report["suppressed"][0]["by"], 0);
  EXPECT_THAT(report::SchemaChecker("report.schema.json").faults(report), testing::IsEmpty());
}

TEST_F(Configuration, ShowsWhatIsInForce) {
  write("base.toml", "up = \"z\"\n");
  write("radlint.toml",
        "extend = \"base.toml\"\nstage = \"solve\"\nexclude = [\"old\"]\nignore = [\"RL005\"]\n[rules.RL240]\n"
        "min-shape = 0.5\n[[objects]]\nobjects = \"rug\"\nignore = [\"RL221\"]\n");
  const Outcome text = radlint({"config", at("a.obj"), "--units", "mm"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  for (const char* expected : {"base.toml:1", "radlint.toml:2", "radlint.toml:6", "--units",
                               "RL005 duplicate-vertex  off", "min-shape = 0.5", "rug: ignore RL221", "old"}) {
    EXPECT_THAT(text.out, HasSubstr(expected));
  }
  const json it = json::parse(radlint({"config", at("a.obj"), "--units", "mm", "--format", "json"}).out);
  EXPECT_EQ(it["files"].size(), 2U);
  EXPECT_EQ(it["settings"]["units"]["value"], "mm");
  EXPECT_EQ(it["settings"]["units"]["origin"], "--units");
  EXPECT_EQ(it["settings"]["fail-on"]["origin"], "default");
  EXPECT_TRUE(it["settings"]["tolerance"]["value"].is_null());
  EXPECT_EQ(json::parse(radlint({"config", at(""), "--isolated", "--format", "json"}).out)["files"].size(), 0U);
  EXPECT_EQ(radlint({"config", at("a.obj"), at("a.obj")}).exit_code, 2);
  EXPECT_EQ(radlint({"config", at("a.obj"), "--format", "xml"}).exit_code, 2);
  write("radlint.toml", "x = 1\n");
  EXPECT_EQ(radlint({"config", at("a.obj")}).exit_code, 2);
}

}  // namespace
}  // namespace rad::cli
