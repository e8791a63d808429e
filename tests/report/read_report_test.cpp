#include "report/read_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/input_record.h"
#include "report/json.h"
#include "report/merge.h"
#include "report/text.h"
#include "validate/message.h"
#include "validate/registry.h"

namespace rad::report {
namespace {

using testing::HasSubstr;

scene::Finding finding(std::string_view rule, double measure) {
  scene::Finding finding = validate::finding_frame(*validate::find_rule(rule), scene::Severity::Error);
  finding.message = "so \"and\" so\x80";
  finding.measure = validate::measure_of(*validate::find_rule(rule), measure, 0.1);
  finding.area = 1.0 / 3;
  finding.where.point = geom::dvec3(0.1, -2e-300, 3e300);
  finding.where.segment = std::array{geom::dvec3(1, 2, 3), geom::dvec3(4, 5, 6)};
  finding.where.file = "room.obj";
  finding.where.line = 12;
  finding.where.pointer = "/meshes/0";
  finding.where.byte_offset = 99;
  finding.where.objects = {"a", "b"};
  finding.where.materials = {"m"};
  finding.where.faces = {{"room.obj:12", 12, ""}, {"x", 0, "/p"}};
  finding.where.face_count = 2;
  finding.where.face_ids = {7, 8};
  finding.where.places = {{geom::dvec3(1, 2, 3), std::nullopt}, {std::nullopt, finding.where.segment}};
  finding.count = 3;
  finding.fingerprint = "0123";
  return finding;
}

InputReport input(const std::string& path, std::size_t findings) {
  InputReport input;
  input.path = path;
  input.format = "obj";
  input.bytes = 1234;
  input.read = true;
  input.metres_per_unit = 0.001;
  input.units_source = ValueSource::Given;
  input.up = scene::UpAxis::Z;
  input.up_source = ValueSource::Declared;
  input.box.add({0, 0, 0});
  input.box.add({1, 2, 3.3});
  validate::LintResult& result = input.result;
  result.pitch = 0.25;
  result.lattice_origin = {1, 2, 3};
  result.tolerance = geom::Tolerance{10.5, 42, 3.7, geom::ToleranceSource::Auto, geom::AutoChoice{2, 1, 4, 5, 6}};
  result.figures = {8, 6, 12, 1, 2, 3};
  result.checked = {validate::find_rule("RL110"), validate::find_rule("RL201"), validate::find_rule("RL240")};
  for (std::size_t i = 0; i < findings; ++i) result.findings.push_back(finding("RL201", static_cast<double>(i)));
  return input;
}

Report report_of(std::vector<InputReport> inputs) {
  Report report;
  report.select = {"RL1", "RL2"};
  report.fail_on = FailOn::Warning;
  report.stage = validate::Stage::Solve;
  report.inputs = std::move(inputs);
  return report;
}

TEST(ReadReport, GivesTheBytesThatItWasReadFrom) {
  Report report = report_of({input("a.obj", 3), input("b.obj", 1)});
  report.inputs[1].result.checked.pop_back();
  report.inputs[1].result.incomplete = "not to the end";
  validate::LintResult& result = report.inputs[1].result;
  result.suppressions = {{scene::WaiverOrigin::Sidecar, {"RL2"}, "why", {"b.obj.radlint.toml", 3, {}, {}}, 1, 3}};
  result.suppressed = {{finding("RL201", 7), 0}};
  const std::string text = json(report);
  const ReadBack back = read_report(text);
  EXPECT_EQ(back.problem, "");
  EXPECT_EQ(back.report.inputs[1].result.suppressed.size(), 1U);
  EXPECT_EQ(json(back.report), text);
}

TEST(ReadReport, WhatIsNotListedIsStillCounted) {
  Report report = report_of({input("a.obj", 5), input("b.obj", 1)});
  report.max_issues = 2;
  const std::string text = json(report);
  const ReadBack back = read_report(text);
  EXPECT_EQ(json(back.report), text);
  EXPECT_EQ(back.report.inputs[0].result.findings.size(), 2U);
  EXPECT_EQ(counts(back.report), counts(report));
}

TEST(ReadReport, OtherTextsAreRefusedInWords) {
  EXPECT_THAT(read_report("").problem, HasSubstr("empty"));
  EXPECT_THAT(read_report("{}").problem, HasSubstr("no JSON report"));
  EXPECT_THAT(read_report("# Findings\n").problem, HasSubstr("no JSON report"));
  std::string text = json(report_of({input("a.obj", 1)}));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return read_report(other).problem;
  };
  EXPECT_THAT(changed("\"schemaVersion\": \"1", "\"schemaVersion\": \"9"), HasSubstr("schemaVersion"));
  EXPECT_THAT(changed("\"rule\": \"RL201\"", "\"rule\": \"RL998\""), HasSubstr("RL998"));
  EXPECT_THAT(changed("\"input\": 0", "\"input\": 7"), HasSubstr("names an input"));
  EXPECT_THAT(changed("\"stage\": \"solve\"", "\"stage\": \"dance\""), HasSubstr("dance"));
}

TEST(InputRecord, HoldsEverything) {
  InputReport before = input("a.obj", 2);
  before.result.timings = {{"read", 0.5}};
  before.result.refusal = "too small";
  const std::optional<InputReport> after = input_of_record(record_of(before));
  ASSERT_TRUE(after);
  EXPECT_EQ(json(report_of({*after}), true), json(report_of({before}), true));
  EXPECT_EQ(after->result.refusal, "too small");
  const scene::Where& where = after->result.findings[0].where;
  EXPECT_EQ(where.face_ids, before.result.findings[0].where.face_ids);
  ASSERT_EQ(where.places.size(), 2U);
  EXPECT_FALSE(where.places[0].segment);
  EXPECT_EQ(where.places[1].segment, before.result.findings[0].where.segment);
  EXPECT_EQ(record_of(*after), record_of(before));
}

TEST(InputRecord, LeavesOutWhatIsNotAskedFor) {
  const InputReport before = input("a.obj", 2);
  ASSERT_FALSE(before.result.findings[0].where.faces.empty());
  const std::string record = record_of(before);
  const auto faces = input_of_record(record, Detail::Faces);
  ASSERT_TRUE(faces);
  EXPECT_EQ(json(report_of({*faces})), json(report_of({before})));
  EXPECT_TRUE(faces->result.findings[0].where.face_ids.empty());
  EXPECT_TRUE(faces->result.findings[0].where.places.empty());
  const auto findings = input_of_record(record, Detail::Findings);
  ASSERT_TRUE(findings);
  EXPECT_EQ(text(report_of({*findings})), text(report_of({before})));
  EXPECT_TRUE(findings->result.findings[0].where.faces.empty());
}

TEST(InputRecord, DamagedBytesAreNone) {
  const std::string record = record_of(input("a.obj", 1));
  for (std::size_t length = 0; length < record.size(); ++length) {
    EXPECT_FALSE(input_of_record(record.substr(0, length))) << length;
  }
  EXPECT_FALSE(input_of_record("nonsense"));
}

class Merge : public testing::Test {
 protected:
  static Report shard(std::size_t index, std::vector<std::size_t> positions) {
    std::vector<InputReport> inputs;
    for (const std::size_t position : positions) inputs.push_back(input(std::to_string(position) + ".obj", position));
    Report report = report_of(std::move(inputs));
    report.shard = Shard{index, 3, 4, std::move(positions)};
    return report;
  }

  // As they come from files.
  static Joined merged_text(const std::vector<Report>& reports) {
    std::vector<Report> back;
    for (const Report& report : reports) back.push_back(read_report(json(report)).report);
    return merged(std::move(back));
  }
};

TEST_F(Merge, ShardsGiveTheBytesOfTheWholeRun) {
  const Report whole = report_of({input("0.obj", 0), input("1.obj", 1), input("2.obj", 2), input("3.obj", 3)});
  const Joined joined = merged_text({shard(2, {0, 3}), shard(3, {}), shard(1, {1, 2})});
  EXPECT_EQ(joined.problem, "");
  EXPECT_EQ(json(joined.report), json(whole));
}

TEST_F(Merge, MissingAndRepeatedShardsAreNamed) {
  EXPECT_THAT(merged_text({shard(2, {0, 3}), shard(1, {1, 2})}).problem, HasSubstr("3/3 missing"));
  EXPECT_THAT(merged_text({shard(1, {0}), shard(2, {1}), shard(3, {2})}).problem, HasSubstr("3 of the 4 files"));
  EXPECT_THAT(merged_text({shard(1, {0, 1}), shard(2, {1}), shard(3, {2})}).problem, HasSubstr("the same file"));
}

TEST_F(Merge, ReportsOfDifferentRunsFollowEachOther) {
  const Report a = report_of({input("a.obj", 1)}), b = report_of({input("b.obj", 2)});
  EXPECT_EQ(json(merged_text({b, a}).report), json(report_of({input("b.obj", 2), input("a.obj", 1)})));
  EXPECT_THAT(merged_text({a, a}).problem, HasSubstr("a.obj is in more than one"));
  Report other = b;
  other.stage = validate::Stage::Model;
  EXPECT_THAT(merged_text({a, other}).problem, HasSubstr("different stages"));
  EXPECT_THAT(merged_text({a, shard(1, {0})}).problem, HasSubstr("shards"));
}

}  // namespace
}  // namespace rad::report
