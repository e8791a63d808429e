#include "report/sarif.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "sample_reports.h"
#include "schema_checker.h"

namespace rad::report {
namespace {

using nlohmann::json;
using samples::broken_input;
using samples::report_on;

json run_of(const Report& report, const WriteOptions& options = {}, std::size_t limit = kSarifResults) {
  return json::parse(sarif(report, options, limit))["runs"][0];
}

json uri_of(const std::string& path, const std::string& root) {
  Report report = report_on({broken_input(path)});
  WriteOptions options;
  options.root = root;
  return run_of(report, options)["artifacts"][0]["location"];
}

/// `findings` errors and as many warnings of another rule.
Report large_report(std::size_t findings) {
  InputReport input = samples::clean_input();
  for (std::size_t i = 0; i < findings; ++i) {
    scene::Finding finding = samples::t_vertex(i + 1, static_cast<double>(i));
    finding.fingerprint = std::to_string(i);
    input.result.findings.push_back(finding);
  }
  for (std::size_t i = 0; i < findings; ++i) {
    input.result.findings.push_back(samples::open_boundary());
    input.result.findings.back().severity = scene::Severity::Warning;
  }
  return report_on({input});
}

TEST(Sarif, FitsTheFormat) {
  const SchemaChecker checker("../tests/report/sarif_subset.schema.json");
  Report stage = report_on({broken_input()});
  stage.stage = validate::Stage::Display;
  for (const Report& report :
       {report_on({samples::clean_input()}), report_on({broken_input(), samples::unreadable_input()}), stage,
        report_on({samples::hostile_input()}), large_report(3000)}) {
    EXPECT_THAT(checker.faults(json::parse(sarif(report, {}))), testing::IsEmpty());
  }
}

TEST(Sarif, CheckerFindsFaults) {
  const SchemaChecker checker("../tests/report/sarif_subset.schema.json");
  json log = json::parse(sarif(report_on({broken_input()}), {}));
  log["runs"][0]["results"][0]["locations"] = json::array();
  log["runs"][0]["results"][1]["message"].erase("text");
  log["runs"][0]["tool"]["driver"].erase("name");
  EXPECT_GE(checker.faults(log).size(), 3U);
}

TEST(Sarif, RulesAreAllThere) {
  const json run = run_of(report_on({broken_input()}));
  const json& rules = run["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), validate::all_rules().size());
  for (const json& result : run["results"])
    EXPECT_EQ(rules[result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
  for (const json& rule : rules) EXPECT_THAT(rule["help"]["markdown"].get<std::string>(), testing::HasSubstr("## Fix"));
}

TEST(Sarif, PlacesAndFingerprints) {
  const json run = run_of(report_on({broken_input()}));
  const json& result = run["results"][0];
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["region"]["startLine"], 120);
  EXPECT_EQ(result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"], "floor");
  EXPECT_EQ(result["partialFingerprints"]["primaryLocationLineHash"], "0123456789abcdef:1");
  EXPECT_EQ(result["partialFingerprints"]["radlint/v1"], "0123456789abcdef");
  EXPECT_EQ(result["properties"]["point"], json::parse("[1.25, 0.0, 3.5]"));
}

TEST(Sarif, FaceOnAnotherLineIsRelated) {
  Report report = report_on({broken_input()});
  report.inputs[0].result.findings[0].where.faces.push_back({"room.obj:7", 7, ""});
  const json result = run_of(report)["results"][0];
  EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["region"]["startLine"], 7);
  EXPECT_THAT(result["message"]["text"].get<std::string>(), testing::EndsWith("([other face](1))"));
}

TEST(Sarif, PathsAreRelativeToTheRoot) {
  EXPECT_EQ(uri_of("models/room 1.obj", "/ci/build"),
            json::parse(R"({"uri":"models/room%201.obj","uriBaseId":"%SRCROOT%"})"));
  EXPECT_EQ(uri_of("./a.obj", "/ci/build")["uri"], "a.obj");
  EXPECT_EQ(uri_of("/ci/build/models/a.obj", "/ci/build"),
            json::parse(R"({"uri":"models/a.obj","uriBaseId":"%SRCROOT%"})"));
  EXPECT_EQ(uri_of("/elsewhere/ä.obj", "/ci/build"), json::parse(R"({"uri":"file:///elsewhere/%C3%A4.obj"})"));
  EXPECT_EQ(uri_of("C:odd.obj", "")["uri"], "C%3Aodd.obj");
}

TEST(Sarif, NamesMakeNoLinks) {
  const json result = run_of(report_on({samples::hostile_input()}))["results"][0];
  EXPECT_THAT(result["message"]["text"].get<std::string>(), testing::HasSubstr("\\[x\\](y)"));
}

TEST(Sarif, WorstOfEveryRuleAreKept) {
  const json run = run_of(large_report(30), {}, 20);
  std::map<std::string, std::size_t> listed;
  for (const json& result : run["results"]) ++listed[result["ruleId"]];
  EXPECT_EQ(run["results"].size(), 20U);
  EXPECT_EQ(listed["RL201"], 19U);  // errors first; one of them says how many are missing
  EXPECT_EQ(listed["RL101"], 1U);
  EXPECT_EQ(run["results"][18]["message"]["text"], "30 more findings of open-boundary that are not listed one by one");
  EXPECT_THAT(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"].get<std::string>(),
              testing::HasSubstr("42 findings are not listed"));
}

TEST(Sarif, PartialJudgementIsSaid) {
  Report report = report_on({broken_input()});
  report.inputs[0].result.incomplete = "too dense";
  EXPECT_EQ(run_of(report)["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"],
            "room.obj: too dense");
}

}  // namespace
}  // namespace rad::report
