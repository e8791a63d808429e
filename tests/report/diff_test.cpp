#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/diff_report.h"
#include "sample_reports.h"
#include "schema_checker.h"

namespace rad::report {
namespace {

using nlohmann::json;
using samples::broken_input;
using samples::clean_input;
using samples::report_on;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Report with(std::vector<scene::Finding> findings, const std::string& format = "obj") {
  InputReport input = clean_input("room." + format);
  input.format = format;
  input.result.findings = std::move(findings);
  return report_on({input});
}

scene::Finding named(scene::Finding finding, const std::string& fingerprint) {
  finding.fingerprint = fingerprint;
  return finding;
}

/// One is new, one worse, one fixed, one unchanged.
struct Mixed {
  Mixed() {
    old = with({named(samples::t_vertex(1, 0), "a"), named(samples::t_vertex(2, 20), "b"),
                named(samples::open_boundary(), "o")});
    now = with({named(samples::t_vertex(5, 0), "a"), named(samples::t_vertex(7, 40), "c"),
                named(samples::open_boundary(), "o")});
    now.inputs[0].result.findings[0].count = 5;
  }
  Report old, now;
};

std::vector<std::string> statuses(const Diff& diff) {
  std::vector<std::string> names;
  for (const DiffFile& file : diff.files) {
    for (const DiffRow& row : file.rows) names.emplace_back(name(row.status));
  }
  return names;
}

TEST(Diff, StatusesInOrder) {
  const Mixed mixed;
  const Diff diff = diff_of(mixed.old, mixed.now);
  EXPECT_THAT(statuses(diff), ElementsAre("new", "changed", "fixed", "unchanged"));
  EXPECT_EQ(diff.files[0].rows[1].change, "3 places before, 5 now");
  EXPECT_TRUE(diff.files[0].rows[1].worse);
  EXPECT_EQ(regressions(diff), (Counts{2, 0, 0}));
  EXPECT_TRUE(fails(diff));
}

TEST(Diff, SameReportIsUnchanged) {
  const Report report = report_on({broken_input(), samples::unreadable_input()});
  const Diff diff = diff_of(report, report);
  EXPECT_THAT(statuses(diff), testing::Each("unchanged"));
  EXPECT_FALSE(fails(diff));
}

TEST(Diff, FewerPlacesAreNoRegression) {
  Report now = with({named(samples::t_vertex(1, 0), "a")});
  now.inputs[0].result.findings[0].count = 2;
  const Report old = with({named(samples::t_vertex(1, 0), "a")});
  const Diff diff = diff_of(old, now);
  EXPECT_THAT(statuses(diff), ElementsAre("changed"));
  EXPECT_FALSE(fails(diff));
}

TEST(Diff, MeasuresChangeByMoreThanNoise) {
  const auto with_measure = [](double value) {
    Report report = with({named(samples::t_vertex(1, 0), "a")});
    report.inputs[0].result.findings[0].measure->value = value;
    return report;
  };
  const Report old = with_measure(0.1);
  EXPECT_THAT(statuses(diff_of(old, with_measure(0.105))), ElementsAre("unchanged"));
  EXPECT_THAT(statuses(diff_of(old, with_measure(0.2))), ElementsAre("changed"));
  EXPECT_THAT(statuses(diff_of(with_measure(1e-9), with_measure(1e-5))), ElementsAre("unchanged"));  // below T
}

TEST(Diff, FailsByTheSeverityThatWasAskedFor) {
  const Report old = with({});
  Report now = with({named(samples::open_boundary(), "o")});
  EXPECT_FALSE(fails(diff_of(old, now)));
  now.fail_on = FailOn::Note;
  EXPECT_TRUE(fails(diff_of(old, now)));
}

TEST(Diff, WhatAFormatCannotHoldIsNoChangeOfTheModel) {
  scene::Finding concave = named(samples::t_vertex(1, 0), "q");
  concave.rule = "RL230";
  concave.alias = "not-simple";
  const Report old = with({concave});
  EXPECT_THAT(statuses(diff_of(old, with({}, "glb"))), ElementsAre("format"));
  EXPECT_THAT(statuses(diff_of(old, with({}, "obj"))), ElementsAre("fixed"));
}

TEST(Diff, FilesThatComeAndGo) {
  const Report old = report_on({broken_input("a.obj"), clean_input("b.obj")});
  const Report now = report_on({clean_input("b.obj"), broken_input("c.obj")});
  const Diff diff = diff_of(old, now);
  EXPECT_EQ(counts(diff)[DiffStatus::New], 3U);
  EXPECT_EQ(counts(diff)[DiffStatus::Fixed], 3U);
  EXPECT_THAT(diff_text(diff), HasSubstr("c.obj (was not there before)\n"));
  EXPECT_THAT(diff_text(diff), HasSubstr("a.obj (gone)\n"));
}

TEST(DiffText, ReadsLikeThis) {
  const Mixed mixed;
  EXPECT_EQ(diff_text(diff_of(mixed.old, mixed.now)), R"(room.obj

new     error RL201 t-vertex  1 finding
  room.obj:7  at (40, 0, 3.5)
    3 T-vertices on an edge of "floor"

changed error RL201 t-vertex  1 finding
  room.obj:5  at (0, 0, 3.5)
    3 T-vertices on an edge of "floor"
    3 places before, 5 now

fixed   error RL201 t-vertex  1 finding
  room.obj:2  at (20, 0, 3.5)
    3 T-vertices on an edge of "floor"

FAIL  1 new, 1 changed, 1 fixed, 1 unchanged
new or worse: 2 errors
)");
}

TEST(DiffText, TolerancesThatDifferAreSaid) {
  Mixed mixed;
  mixed.now.inputs[0].result.tolerance->length = 0.0003;
  EXPECT_THAT(diff_text(diff_of(mixed.old, mixed.now)), HasSubstr("T was 0.0002 units, is 0.0003 units"));
}

TEST(DiffMarkdown, VerdictTablesAndRows) {
  const Mixed mixed;
  const std::string out = diff_markdown(diff_of(mixed.old, mixed.now));
  EXPECT_THAT(out, StartsWith("<!-- radlint-diff -->\n## radlint: **FAIL**\n\n1 new, 1 changed, 1 fixed, 1 unchanged"));
  EXPECT_THAT(out, HasSubstr("| RL201 `t-vertex` | "));
  EXPECT_THAT(out, HasSubstr(" | 1 | 1 | 1 | 0 |\n"));
  EXPECT_THAT(out, HasSubstr("\n#### New\n"));
  EXPECT_THAT(out, HasSubstr("(3 places before, 5 now) |\n"));
}

TEST(DiffMarkdown, StaysBelowTheLimit) {
  Report old, now;
  for (int i = 0; i < 800; ++i) {
    old.inputs.push_back(clean_input("m/room_" + std::to_string(i) + ".obj"));
    now.inputs.push_back(broken_input("m/room_" + std::to_string(i) + ".obj"));
  }
  const std::string out = diff_markdown(diff_of(old, now));
  EXPECT_LT(out.size(), kMarkdownLimit);
  EXPECT_THAT(out, HasSubstr("2400 new"));
  EXPECT_THAT(out, HasSubstr("left out here"));
}

TEST(DiffJson, FitsTheSchema) {
  const SchemaChecker checker("diff.schema.json");
  const Mixed mixed;
  const Report hostile = report_on({samples::hostile_input(), samples::unreadable_input()});
  const Report clean = report_on({clean_input("x.obj")});
  for (const Diff& diff : {diff_of(mixed.old, mixed.now), diff_of(hostile, clean), diff_of(clean, hostile)}) {
    EXPECT_THAT(checker.faults(json::parse(diff_json(diff))), testing::IsEmpty());
  }
  json broken = json::parse(diff_json(diff_of(mixed.old, mixed.now)));
  broken["files"][0]["rows"][0]["status"] = "moved";
  EXPECT_THAT(checker.faults(broken), Not(testing::IsEmpty()));
}

TEST(DiffJson, HasEveryRowWithItsFindings) {
  const Mixed mixed;
  const json diff = json::parse(diff_json(diff_of(mixed.old, mixed.now)));
  const json& rows = diff["files"][0]["rows"];
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0]["old"], json::array());
  EXPECT_EQ(rows[1]["old"][0]["count"], 3);
  EXPECT_EQ(rows[1]["new"][0]["count"], 5);
  EXPECT_EQ(diff["summary"], json::parse(R"({"new":1,"changed":1,"fixed":1,"unchanged":1,"format":0})"));
}

}  // namespace
}  // namespace rad::report
