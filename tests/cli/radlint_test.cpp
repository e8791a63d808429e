#include "cli/radlint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Outcome radlint(const std::vector<std::string>& args, const Terminal& terminal = {}) {
  return outcome_of(&run_radlint, args, terminal);
}

class Radlint : public InFolder {};

TEST_F(Radlint, CleanBoxPasses) {
  const Outcome outcome = radlint({write("box.obj", kBox)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("\npass  "));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Radlint, FlippedFaceFailsWithItsLine) {
  const Outcome outcome = radlint({write("box.obj", kBoxWithFlippedFace)});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("RL110"));
  EXPECT_THAT(outcome.out, HasSubstr("box.obj:14"));
}

TEST_F(Radlint, FailOnDecidesTheExitCode) {
  const std::string square = write("square.obj", kSquare);
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  EXPECT_EQ(radlint({square}).exit_code, 0);
  EXPECT_EQ(radlint({square, "--fail-on", "note"}).exit_code, 1);
  EXPECT_EQ(radlint({box, "--fail-on", "never"}).exit_code, 0);
}

TEST_F(Radlint, UnreadableFileIsAFindingAndOthersAreJudged) {
  const std::string bad = write("bad.ply", "ply\nformat ascii 1.0\nelement");
  const Outcome outcome = radlint({bad, write("box.obj", kBox), "--format", "json", "--select", "RL2"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["verdict"], "fail");
  EXPECT_TRUE(report["summary"]["byRule"].contains("RL001"));
  EXPECT_EQ(report["inputs"][0]["read"], false);
  EXPECT_EQ(report["inputs"][1]["figures"]["faces"], 6);
}

// Copies of one triangle all meet each other: more contacts than the search keeps.
TEST_F(Radlint, CrowdedSceneIsJudgedInPart) {
  std::string crowd = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 2100; ++i) crowd += "f 1 2 3\n";
  const Outcome outcome = radlint({write("crowd.obj", crowd), "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 3);
  const json report = json::parse(outcome.out);
  EXPECT_THAT(report["inputs"][0]["incomplete"].get<std::string>(), HasSubstr("not every pair was tested"));
  EXPECT_TRUE(report["summary"]["byRule"].contains("RL220"));
}

TEST_F(Radlint, MissingPathStopsTheRun) {
  const Outcome outcome = radlint({write("box.obj", kBox), at("none.obj")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("none.obj: no such file or folder"));
}

TEST_F(Radlint, StandardInputIsRefusedInWords) {
  EXPECT_EQ(radlint({"-"}).exit_code, 2);
  EXPECT_THAT(radlint({"-"}).err, HasSubstr("standard input"));
}

TEST_F(Radlint, FoldersAreSearchedInOrder) {
  write("models/z.OBJ", kBox);
  write("models/sub/a.obj", kBox);
  write("models/readme.txt", "no model");
  write("models/.hidden/b.obj", kBox);
  const Outcome outcome = radlint({at("models"), at("models/z.OBJ"), "--format", "json"});
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["inputs"].size(), 2U);
  EXPECT_EQ(report["inputs"][0]["path"], at("models/sub/a.obj"));
  EXPECT_EQ(report["inputs"][1]["path"], at("models/z.OBJ"));
}

TEST_F(Radlint, FolderWithoutModelsIsAUsageError) {
  write("empty/readme.txt", "no model");
  EXPECT_EQ(radlint({at("empty")}).exit_code, 2);
}

TEST_F(Radlint, ReportsGoToFiles) {
  const Outcome outcome = radlint({write("box.obj", kBoxWithFlippedFace), "--report", "json=" + at("r.json"),
                                   "--report", "text=" + at("r.txt"), "-q", "--color", "always"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(json::parse(read("r.json"))["verdict"], "fail");
  EXPECT_THAT(read("r.txt"), testing::Not(HasSubstr("\x1b")));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(at("")), std::filesystem::directory_iterator()), 3);
}

TEST_F(Radlint, ReportThatCannotBeWritten) {
  const std::string box = write("box.obj", kBox);
  const Outcome outcome = radlint({box, "--report", "json=" + at("none/r.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("none/r.json"));
  EXPECT_EQ(radlint({box, "--report", "json=" + at("")}).exit_code, 2);
}

TEST_F(Radlint, ReportThroughALinkReplacesItsTarget) {
  write("target.json", "old");
  std::filesystem::create_symlink("target.json", at("link.json"));
  EXPECT_EQ(radlint({write("box.obj", kBox), "--report", "json=" + at("link.json")}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(at("link.json")));
  EXPECT_EQ(json::parse(read("target.json"))["verdict"], "pass");
}

TEST_F(Radlint, ToleranceBelowTheLatticeIsRefused) {
  const Outcome outcome = radlint({write("box.obj", kBox), "--tolerance", "1e-12"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("box.obj: "));
}

TEST_F(Radlint, UnitsMakeMetres) {
  const Outcome outcome =
      radlint({write("box.obj", kBoxWithFlippedFace), "--units", "mm", "--up", "z", "--format", "json"});
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["inputs"][0]["units"], json::parse(R"({"value":"mm","metresPerUnit":0.001,"source":"given"})"));
  EXPECT_EQ(report["inputs"][0]["up"]["source"], "given");
  const json& where = report["findings"][0]["where"];
  EXPECT_DOUBLE_EQ(where["pointMetres"][0].get<double>(), where["point"][0].get<double>() * 0.001);
}

TEST_F(Radlint, SameBytesForAnyNumberOfThreads) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const Outcome one = radlint({box, "--format", "json", "--jobs", "1"});
  const Outcome two = radlint({box, "--format", "json", "--jobs", "2"});
  EXPECT_EQ(one.out, two.out);
}

TEST_F(Radlint, ColourAndProgressFollowTheTerminal) {
  const std::string box = write("box.obj", kBox);
  Terminal terminal;
  terminal.out_is_terminal = true;
  terminal.err_is_terminal = true;
  const Outcome outcome = radlint({box}, terminal);
  EXPECT_THAT(outcome.out, HasSubstr("\x1b[32mpass"));
  EXPECT_THAT(outcome.err, HasSubstr("judging "));
  EXPECT_EQ(radlint({box}).err, "");
}

TEST_F(Radlint, IncompleteOutputIsReported) {
  const std::vector<std::string> args = {write("box.obj", kBox)};
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run_radlint(args, out, err), 2);
  EXPECT_THAT(err.str(), HasSubstr("standard output"));
}

TEST(RadlintRules, PagesAndLists) {
  const Outcome page = radlint({"rule", "t-vertex"});
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, testing::StartsWith("RL201 t-vertex\n"));
  EXPECT_EQ(json::parse(radlint({"rule", "RL201", "--format", "json"}).out)["alias"], "t-vertex");
  EXPECT_THAT(radlint({"rules", "--format", "markdown"}).out, testing::StartsWith("# Rules\n"));
  EXPECT_THAT(radlint({"rules"}).out, HasSubstr("RL201"));
  const Outcome unknown = radlint({"rule", "t-vertx"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean t-vertex?"));
}

TEST(RadlintShared, AcceptanceFilesAreJudged) {
  const char* shared = std::getenv("RAD_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "RAD_SHARED is not set";
  const Outcome outcome = radlint({std::string(shared) + "/corpus/malformed", "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_GT(report["inputs"].size(), 0U);
  std::set<std::string> rules;
  for (const json& finding : report["findings"]) rules.insert(finding["rule"]);
  for (const auto& [rule, total] : report["summary"]["byRule"].items()) EXPECT_TRUE(rules.contains(rule)) << rule;
}

}  // namespace
}  // namespace rad::cli
