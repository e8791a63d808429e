#include "report/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "report/repair_report.h"
#include "sample_reports.h"
#include "schema_checker.h"

namespace rad::report {
namespace {

using nlohmann::json;
using samples::broken_input;
using samples::clean_input;
using samples::report_on;
using samples::unreadable_input;

json parsed(const Report& report) { return json::parse(report::json(report)); }

SchemaChecker lint_schema() { return SchemaChecker("report.schema.json"); }

std::set<std::string> rules_of_findings(const json& report) {
  std::set<std::string> rules;
  for (const json& finding : report["findings"]) rules.insert(finding["rule"]);
  return rules;
}

std::set<std::string> rules_of_summary(const json& report) {
  std::set<std::string> rules;
  for (const auto& [rule, total] : report["summary"]["byRule"].items()) rules.insert(rule);
  return rules;
}

Report with_units() {
  Report report = report_on({broken_input()});
  report.inputs[0].metres_per_unit = 0.0254;
  report.inputs[0].units_source = ValueSource::Given;
  report.inputs[0].up = scene::UpAxis::Y;
  report.inputs[0].up_source = ValueSource::Declared;
  return report;
}

Report with_numbers_that_are_none() {
  Report report = report_on({broken_input()});
  report.inputs[0].result.findings[0].where.point = geom::dvec3{std::numeric_limits<double>::quiet_NaN(), -0.0, 1};
  report.inputs[0].result.findings[0].measure->value = std::numeric_limits<double>::infinity();
  return report;
}

TEST(Json, ReportsFitTheSchema) {
  const SchemaChecker checker = lint_schema();
  Report selected = report_on({broken_input(), clean_input("b.obj"), unreadable_input()});
  selected.select = {"RL2", "t-vertex"};
  selected.stage = validate::Stage::Display;
  for (const Report& report : {report_on({clean_input()}), report_on({broken_input()}), report_on({unreadable_input()}),
                               with_units(), with_numbers_that_are_none(), selected}) {
    EXPECT_THAT(checker.faults(parsed(report)), testing::IsEmpty());
    EXPECT_THAT(checker.faults(json::parse(report::json(report, true))), testing::IsEmpty());
  }
}

TEST(Json, SchemaCheckerFindsFaults) {
  const SchemaChecker checker = lint_schema();
  json report = parsed(report_on({broken_input()}));
  report["findings"][0]["severity"] = "fatal";
  report["findings"][1].erase("where");
  report["summary"]["byRule"]["201"] = report["summary"]["byRule"]["RL201"];
  report["inputs"][0]["host"] = "here";
  report["findings"][0]["where"]["point"] = json::array({1, 2});
  EXPECT_GE(checker.faults(report).size(), 5U);
}

TEST(Json, KeysComeInTheirOrder) {
  const auto report = nlohmann::ordered_json::parse(report::json(report_on({broken_input()})));
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_THAT(keys, testing::ElementsAre("schemaVersion", "tool", "invocation", "inputs", "tolerance", "verdict",
                                         "summary", "findings", "suppressed", "timings"));
}

TEST(Json, CountsFindingsAndPlaces) {
  const json report = parsed(report_on({broken_input()}));
  EXPECT_EQ(report["verdict"], "fail");
  EXPECT_EQ(report["summary"]["errors"], 2);
  EXPECT_EQ(report["summary"]["notes"], 1);
  EXPECT_EQ(report["summary"]["byRule"]["RL201"],
            json::parse(R"({"count":6,"findings":2,"severity":"error","truncated":false})"));
  EXPECT_EQ(report["summary"]["requirements"]["2a"]["status"], "fail");
  EXPECT_EQ(report["summary"]["requirements"]["1a"]["status"], "note");
}

TEST(Json, NotesAlonePass) {
  Report report = report_on({clean_input()});
  report.inputs[0].result.findings = {samples::open_boundary()};
  EXPECT_EQ(parsed(report)["verdict"], "pass");
}

TEST(Json, ListsAtMostMaxIssuesOfEachRule) {
  Report report = report_on({broken_input("a.obj"), broken_input("b.obj")});
  report.max_issues = 1;
  json written = parsed(report);
  EXPECT_EQ(written["findings"].size(), 4U);
  EXPECT_EQ(written["summary"]["byRule"]["RL201"]["findings"], 4);
  EXPECT_EQ(written["summary"]["byRule"]["RL201"]["truncated"], true);
  EXPECT_EQ(written["summary"]["byRule"]["RL101"]["truncated"], false);
  EXPECT_EQ(rules_of_findings(written), rules_of_summary(written));
  report.max_issues = 0;
  written = parsed(report);
  EXPECT_EQ(written["findings"].size(), 6U);
  EXPECT_EQ(written["summary"]["byRule"]["RL201"]["truncated"], false);
}

TEST(Json, ToleranceStandsAtTheTopOfOneInput) {
  EXPECT_EQ(parsed(report_on({clean_input()}))["tolerance"]["T"], 0.0002);
  EXPECT_TRUE(parsed(report_on({unreadable_input()}))["tolerance"].is_null());
  const json two = parsed(report_on({clean_input(), unreadable_input()}));
  EXPECT_TRUE(two["tolerance"].is_null());
  EXPECT_EQ(two["inputs"][0]["tolerance"]["diagonal"], 6.8739);
  EXPECT_TRUE(two["inputs"][1]["tolerance"].is_null());
  EXPECT_EQ(two["findings"][0]["input"], 1);
}

TEST(Json, SaysWhatWasNotJudged) {
  EXPECT_TRUE(parsed(report_on({clean_input()}))["inputs"][0]["incomplete"].is_null());
  Report report = report_on({clean_input()});
  report.inputs[0].result.incomplete = "too dense";
  const json written = parsed(report);
  EXPECT_EQ(written["inputs"][0]["incomplete"], "too dense");
  EXPECT_THAT(lint_schema().faults(written), testing::IsEmpty());
}

TEST(Json, MetresOnlyWhereTheUnitIsKnown) {
  EXPECT_TRUE(parsed(report_on({broken_input()}))["findings"][0]["where"]["pointMetres"].is_null());
  const json report = parsed(with_units());
  EXPECT_DOUBLE_EQ(report["findings"][0]["where"]["pointMetres"][0].get<double>(), 1.25 * 0.0254);
  EXPECT_EQ(report["inputs"][0]["units"]["value"], "in");
  EXPECT_EQ(report["inputs"][0]["units"]["source"], "given");
}

TEST(Json, WritesNullForWhatIsNoNumber) {
  const std::string text = report::json(with_numbers_that_are_none());
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("nan")));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("-0.0")));
  const json report = json::parse(text);
  EXPECT_TRUE(report["findings"][0]["where"]["point"][0].is_null());
  EXPECT_TRUE(report["findings"][0]["measure"]["value"].is_null());
}

TEST(Json, BytesThatAreNotUtf8AreReplaced) {
  Report report = report_on({broken_input("r\xff.obj")});
  report.inputs[0].result.findings[0].where.objects = {"\xc3("};
  EXPECT_EQ(parsed(report)["inputs"][0]["path"], "r\xef\xbf\xbd.obj");
}

TEST(Json, SameReportSameBytesAndTimingsOnlyWhenAsked) {
  const Report report = report_on({broken_input(), clean_input()});
  EXPECT_EQ(report::json(report), report::json(report));
  EXPECT_TRUE(parsed(report)["timings"].empty());
  EXPECT_DOUBLE_EQ(json::parse(report::json(report, true))["timings"]["read"].get<double>(), 0.5);
}

TEST(RepairJson, HoldsBeforeAndAfter) {
  const json kept =
      json::parse(report::json(RepairReport{report_on({clean_input()}), report_on({clean_input("o.obj")})}));
  EXPECT_EQ(kept["tool"]["name"], "radfix");
  EXPECT_EQ(kept["before"]["errors"], 0);
  EXPECT_EQ(kept["after"]["errors"], 0);
  EXPECT_EQ(kept["outputs"][0]["path"], "o.obj");
  EXPECT_TRUE(kept["ledger"].empty());
  const json refused = json::parse(report::json(RepairReport{report_on({broken_input()}), std::nullopt}));
  EXPECT_TRUE(refused["after"].is_null());
  EXPECT_EQ(refused["before"]["byRule"]["RL201"]["count"], 6);
}

RepairReport full_repair_report() {
  RepairReport report{report_on({broken_input()}), report_on({clean_input("o.glb")})};
  report.repair = RepairDone::Done;
  report.stages_asked = {"grouper", "orient"};
  report.stages_done = {"grouper"};
  report.ledger = {{"grouper", "weld", {"RL302"}, 3, 0.0001, std::nullopt},
                   {"orient", "turn-face", {"RL110"}, 1, 0, 0.0},
                   {"orient", "roll-back", {"RL110"}, 1, 0, std::nullopt}};
  report.areas = {{"input", 12.5}, {"grouper", 12}};
  report.changes = Changes{{{"cut", 12, {{{"room.obj:7", 7, ""}, {1, 2, 3}, 0}}}}, {{{1, 2, 3}, 0.01, 4}}, 0.5, 0.25};
  report.provenance = Provenance{3, "0 1+4 2", 5, {{"room.obj", "", scene::RecordKind::Line}}, {{0, "7..11"}}};
  report.contracts = {{"isect", "2b", "generated", 3, 0, true}};
  report.ledger = {{"grouper", "weld", {}, 3, 0.0001, {}},
                   {"grouper", "flatten-plate", {}, 1, 0, {}, {{{1, 2, 3}, {"room.obj:7", 7, ""}, 2.5}}},
                   {"orient", "turn-face", {}, 1, 0, {}}};
  report.removals = {{{"rug", "wool", {"room.obj:9", 9, ""}}, {"", "wood", {}}, 'c', false, 4, 1.5, {0, 0, 1}}};
  scene::Finding thin;
  thin.rule = "RL107";
  thin.alias = "thin-feature";
  thin.requirement = "input";
  thin.severity = scene::Severity::Warning;
  thin.area = 12;
  thin.kept_below = 1e-4;
  report.before.inputs[0].result.findings.push_back(thin);
  report.before.inputs[0].result.tolerance->source = geom::ToleranceSource::Auto;
  report.before.inputs[0].result.tolerance->choice = geom::AutoChoice{1.5, 1e-5, 3e-4, 1e-3, 2};
  report.mesh = MeshFigures{6, 24, 96, 120, 0.5, 0.25, 0.9, 0.4};
  report.solution = SolutionFigures{{{3, 2, 1}, {4, 3, 2}}, 17, true, 0.01};
  report.timings = {{"grouper", 0.5}, {"solve", 2}};
  return report;
}

TEST(RepairJson, ReportsFitTheSchema) {
  const SchemaChecker checker("repair_report.schema.json");
  for (const RepairReport& report : {full_repair_report(), RepairReport{report_on({broken_input()}), std::nullopt},
                                     RepairReport{report_on({unreadable_input()}), std::nullopt}}) {
    EXPECT_THAT(checker.faults(json::parse(report::json(report))), testing::IsEmpty());
  }
}

TEST(RepairJson, ListsWhatIsThinAndWhatWasLostOrHidden) {
  const json report = json::parse(report::json(full_repair_report()));
  ASSERT_EQ(report["thinFeatures"].size(), 1U);
  EXPECT_EQ(report["thinFeatures"][0]["keptBelow"], 1e-4);
  EXPECT_EQ(report["thinFeatures"][0]["area"], 12);
  EXPECT_EQ(report["ledger"][1]["places"][0]["face"]["line"], 7);
  EXPECT_FALSE(report["ledger"][0].contains("places"));
  EXPECT_EQ(report["coplanar"][0]["rule"], "c");
  EXPECT_EQ(report["coplanar"][0]["loser"]["material"], "wood");
  EXPECT_EQ(report["tolerance"]["source"], "auto");
  EXPECT_EQ(report["tolerance"]["confidence"], 1.5);
  EXPECT_EQ(report["tolerance"]["auto"]["joinedBeyondDefault"], 2);
}

TEST(RepairJson, SchemaCheckerFindsFaultsAcrossFiles) {
  const SchemaChecker checker("repair_report.schema.json");
  json report = json::parse(report::json(full_repair_report()));
  report["ledger"][0]["operation"] = "magic";
  report["inputs"][0]["host"] = "here";
  report["before"]["errors"] = -1;
  report["solution"]["energy"]["emitted"] = json::array({1, 2});
  report["timings"]["sleep"] = 1;
  EXPECT_EQ(checker.faults(report).size(), 5U);
}

TEST(RepairJson, KeysComeInTheirOrder) {
  const auto report = nlohmann::ordered_json::parse(report::json(full_repair_report()));
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_THAT(keys, testing::ElementsAre("schemaVersion", "tool", "inputs", "outputs", "tolerance", "before",
                                         "thinFeatures", "after", "dryRun", "stages", "repair", "ledger", "coplanar",
                                         "areas", "distance", "merged", "changes", "provenance", "contracts", "mesh",
                                         "solution", "incomplete", "timings"));
}

}  // namespace
}  // namespace rad::report
