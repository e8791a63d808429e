#include "report/baseline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/concise.h"
#include "report/json.h"
#include "report/sarif.h"
#include "report/text.h"
#include "sample_reports.h"
#include "schema_checker.h"

namespace rad::report {
namespace {

using nlohmann::json;
using samples::report_on;
using scene::BaselineState;
using testing::HasSubstr;
using testing::Not;

Report with(const std::vector<std::pair<std::string, std::uint64_t>>& findings) {
  InputReport input = samples::clean_input("/m/room.obj");
  double x = 0;
  for (const auto& [fingerprint, count] : findings) {
    scene::Finding finding = samples::t_vertex(1, x += 10);
    finding.fingerprint = fingerprint;
    finding.count = count;
    input.result.findings.push_back(finding);
  }
  return report_on({input});
}

TEST(Baseline, KnownFindingsAreSetAside) {
  Report report = with({{"a", 1}, {"b", 1}});
  const auto uses = apply_baseline(with({{"a", 1}}), report);
  ASSERT_EQ(report.inputs[0].result.findings.size(), 1U);
  EXPECT_EQ(report.inputs[0].result.findings[0].fingerprint, "b");
  EXPECT_EQ(report.inputs[0].result.findings[0].baseline, BaselineState::New);
  EXPECT_EQ(known_findings(report), 1U);
  EXPECT_TRUE(uses.at(0).stale.empty());
}

TEST(Baseline, GrownFindingsAreNotKnown) {
  Report report = with({{"a", 4}});
  apply_baseline(with({{"a", 3}}), report);
  ASSERT_EQ(report.inputs[0].result.findings.size(), 1U);
  EXPECT_EQ(report.inputs[0].result.findings[0].baseline, BaselineState::Grown);
  Report shrunk = with({{"a", 2}});
  apply_baseline(with({{"a", 3}}), shrunk);
  EXPECT_EQ(known_findings(shrunk), 1U);
}

TEST(Baseline, StaleEntriesAreNamedAndPruned) {
  const Report baseline = with({{"a", 1}, {"b", 1}, {"c", 1}});
  Report report = with({});
  report.inputs[0].result.findings = {baseline.inputs[0].result.findings[1]};
  const auto uses = apply_baseline(baseline, report);
  EXPECT_THAT(uses.at(0).stale, testing::ElementsAre(0, 2));
  const Report rest = pruned(baseline, uses);
  ASSERT_EQ(rest.inputs[0].result.findings.size(), 1U);
  EXPECT_EQ(rest.inputs[0].result.findings[0].fingerprint, "b");
}

TEST(Baseline, FilesThatWereNotJudgedStay) {
  Report baseline = with({{"a", 1}});
  baseline.inputs.push_back(baseline.inputs[0]);
  baseline.inputs[1].path = "/m/hall.obj";
  Report report = with({{"a", 1}});
  EXPECT_EQ(apply_baseline(baseline, report).size(), 1U);
}

TEST(Baseline, FileIsAReportWithALineForEachFinding) {
  const std::string text = baseline_json(with({{"a", 1}, {"b", 2}}), "/m");
  EXPECT_THAT(SchemaChecker("report.schema.json").faults(json::parse(text)), testing::IsEmpty());
  const json baseline = json::parse(text);
  EXPECT_EQ(baseline["inputs"][0]["path"], "room.obj");
  EXPECT_EQ(baseline["findings"].size(), 2U);
  EXPECT_TRUE(baseline["findings"][0]["where"]["line"].is_null());
  EXPECT_THAT(text,
              testing::ContainsRegex("\n    [{]\"rule\":\"RL201\".*[}],\n    [{]\"rule\":\"RL201\".*[}]\n  ],\n"));
  EXPECT_EQ(json::parse(baseline_json(with({}), "/m"))["findings"], json::array());
}

TEST(Baseline, ReportsCountWhatIsKnown) {
  Report report = with({{"a", 1}, {"b", 1}});
  apply_baseline(with({{"a", 1}}), report);
  const json written = json::parse(report::json(report));
  EXPECT_THAT(SchemaChecker("report.schema.json").faults(written), testing::IsEmpty());
  EXPECT_EQ(written["summary"]["known"], 1);
  EXPECT_EQ(written["summary"]["errors"], 1);
  EXPECT_EQ(written["findings"][0]["baseline"], "new");
  EXPECT_THAT(text(report), HasSubstr("1 finding is in the baseline and not listed\n"));
}

TEST(Baseline, SarifHasTheirStates) {
  Report report = with({{"a", 1}, {"b", 3}, {"c", 1}});
  apply_baseline(with({{"a", 1}, {"b", 2}}), report);
  std::vector<std::string> states;
  const json log = json::parse(sarif(report, {}));
  for (const json& result : log["runs"][0]["results"]) states.push_back(result["baselineState"]);
  EXPECT_THAT(states, testing::ElementsAre("updated", "new", "unchanged"));
}

}  // namespace
}  // namespace rad::report
