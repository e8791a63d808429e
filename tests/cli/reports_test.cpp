// Reports, baselines and annotated models of radlint and radfix, as files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "cli/radlint.h"
#include "readers/reader.h"
#include "report/formats.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Outcome radlint(const std::vector<std::string>& args) { return outcome_of(&run_radlint, args); }

class Reports : public InFolder {
 protected:
  json report_with(std::vector<std::string> args, int exit_code) const {
    args.insert(args.end(), {"--format", "json"});
    const Outcome outcome = radlint(args);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err << outcome.out;
    return json::parse(outcome.out);
  }
};

TEST_F(Reports, AllFormatsInOneRun) {
  std::vector<std::string> args{write("box.obj", kBoxWithFlippedFace), "-q"};
  for (const report::ReportFormat& format : report::report_formats()) {
    args.insert(args.end(), {"--report", std::string(format.name) + "=" + at(std::string(format.name))});
  }
  const Outcome outcome = radlint(args);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const report::ReportFormat& format : report::report_formats()) {
    EXPECT_NE(read(std::string(format.name)), "") << format.name;
  }
}

TEST_F(Reports, StandardOutputTakesEveryFormat) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  for (const report::ReportFormat& format : report::report_formats()) {
    EXPECT_EQ(radlint({box, "--format", std::string(format.name)}).exit_code, 1) << format.name;
  }
}

TEST_F(Reports, SayWhatTheyLeaveOut) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const auto kept = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {box, "--no-group"});
    return report_with(std::move(more), 1)["summary"]["byRule"];
  };
  const json short_list = report_with({box, "--no-group", "--max-issues", "1"}, 1);
  EXPECT_EQ(short_list["summary"]["byRule"]["RL902"]["severity"], "note");
  const auto& findings = short_list["findings"];
  const auto note = std::ranges::find_if(findings, [](const json& finding) { return finding["rule"] == "RL902"; });
  ASSERT_NE(note, findings.end());
  EXPECT_THAT(std::string((*note)["message"]), HasSubstr("1 of 4 findings of RL110"));
  EXPECT_GE((*note)["count"], 3);
  EXPECT_FALSE(kept({"--max-issues", "0"}).contains("RL902"));
  EXPECT_FALSE(kept({"--max-issues", "1", "--ignore", "RL902"}).contains("RL902"));
  EXPECT_THAT(radlint({box, "--no-group", "--max-issues", "1"}).out, testing::Not(HasSubstr("RL902")));
}

TEST_F(Reports, LengthOfAListIsNoFaultOfTheModel) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const std::string list = at("list.json");
  radlint({box, "--no-group", "--max-issues", "1", "--report", "json=" + list, "-q"});
  ASSERT_THAT(read("list.json"), HasSubstr("RL902"));
  EXPECT_EQ(radlint({"merge", list, "--format", "json"}).out, read("list.json"));
  EXPECT_THAT(radlint({"merge", list}).out, HasSubstr("RL902"));
  EXPECT_FALSE(report_with({box, "--no-group", "--baseline", list}, 1)["summary"]["byRule"].contains("RL904"));
  EXPECT_THAT(radlint({"diff", list, box}).out, testing::Not(HasSubstr("RL902")));
}

TEST_F(Reports, OfWhatRadfixWrote) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const Outcome outcome =
      outcome_of(&run_radfix, {box, "-o", at("out.obj"), "--report", "json=" + at("r.json"), "--report",
                               "sarif=" + at("r.sarif"), "--report", "text=" + at("r.txt")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(read("r.json"))["before"]["errors"], 1);
  const json run = json::parse(read("r.sarif"))["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["name"], "radfix");
  for (const json& result : run["results"]) EXPECT_NE(result["level"], "error");
  EXPECT_EQ(read("r.txt"), outcome.out);
}

TEST_F(Reports, BaselineAcceptsWhatIsThere) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  EXPECT_EQ(report_with({box, "--write-baseline", at("b.json")}, 0)["summary"]["errors"], 0);
  const json summary = report_with({box, "--baseline", at("b.json")}, 0)["summary"];
  EXPECT_EQ(summary["errors"], 0);
  EXPECT_GE(summary["known"], 1);
}

TEST_F(Reports, BaselineFindsItsFilesFromAnywhere) {
  write("models/a/box.obj", kBoxWithFlippedFace);
  write("models/b/box.obj", kBox);
  EXPECT_EQ(radlint({at("models"), "--write-baseline", at("models/b.json")}).exit_code, 0);
  EXPECT_THAT(read("models/b.json"), HasSubstr("\"path\": \"a/box.obj\""));
  EXPECT_EQ(radlint({at("models/a/box.obj"), "--baseline", at("models/b.json")}).exit_code, 0);
  write("models/b/box.obj", kBoxWithFlippedFace);
  EXPECT_EQ(radlint({at("models"), "--baseline", at("models/b.json")}).exit_code, 1);
}

TEST_F(Reports, BaselineUsageErrors) {
  const std::string box = write("box.obj", kBox);
  EXPECT_EQ(radlint({box, "--baseline", at("none.json")}).exit_code, 2);
  EXPECT_EQ(radlint({box, "--baseline", write("bad.json", "{")}).exit_code, 2);
  EXPECT_EQ(radlint({box, "--prune-baseline"}).exit_code, 2);
  EXPECT_EQ(radlint({box, "--strict-baseline"}).exit_code, 2);
  EXPECT_EQ(radlint({box, "--baseline", "a", "--write-baseline", "b"}).exit_code, 2);
}

TEST_F(Reports, AnnotatedModelNamesTheRules) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  EXPECT_EQ(radlint({box, "--annotate", at("a.glb")}).exit_code, 1);
  const readers::ReadResult read = readers::read_file(at("a.glb"));
  std::map<std::string, std::size_t> triangles;
  for (const scene::Face& face : read.scene.faces) ++triangles[read.scene.objects[face.object]];
  EXPECT_GE(triangles["RL110 normal-inconsistent"], 2U);
  EXPECT_EQ(triangles.count("no finding"), 1U);
  EXPECT_THAT(this->read("a.glb"), HasSubstr("RL110"));
}

TEST_F(Reports, AnnotatedModelDividesPolygons) {
  const std::string model = std::string(RAD_SOURCE_DIR) + "/corpus/models/lamp_post.obj";
  const Outcome outcome = radlint({model, "--annotate", at("a.glb")});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const readers::ReadResult read = readers::read_file(at("a.glb"));
  EXPECT_THAT(read.scene.objects, testing::Contains("RL210 implicit-intersection"));
  EXPECT_THAT(read.scene.objects, testing::Contains("no finding"));
}

TEST_F(Reports, AnnotateUsageErrors) {
  const std::string box = write("box.obj", kBox);
  EXPECT_EQ(radlint({box, "--annotate", at("a.obj")}).exit_code, 2);
  EXPECT_EQ(radlint({box, write("other.obj", kBox), "--annotate", at("a.glb")}).exit_code, 2);
}

}  // namespace
}  // namespace rad::cli
