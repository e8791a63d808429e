#include "report/junit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sample_reports.h"
#include "xml_reader.h"

namespace rad::report {
namespace {

using samples::broken_input;
using samples::report_on;
using testing::HasSubstr;

XmlElement suites_of(const Report& report, bool timings = false) {
  XmlDocument document = read_xml(junit(report, timings));
  EXPECT_EQ(document.fault, "");
  return document.root;
}

XmlElement case_of(const XmlElement& suite, const std::string& rule) {
  const auto found = std::ranges::find_if(
      suite.children, [&](const XmlElement& child) { return child.attributes.at("name").starts_with(rule); });
  EXPECT_NE(found, suite.children.end()) << rule;
  return *found;
}

std::string outcome_of(const XmlElement& test_case) {
  return test_case.children.empty() ? "pass" : test_case.children.front().name;
}

TEST(Junit, SuiteForEachModelAndCaseForEachRule) {
  const XmlElement suites = suites_of(report_on({broken_input("rooms/a.b.obj"), samples::clean_input("c.glb")}));
  ASSERT_EQ(suites.children.size(), 2U);
  EXPECT_EQ(suites.children[0].attributes.at("name"), "rooms/a.b.obj");
  EXPECT_EQ(suites.children[0].children.size(), validate::all_rules().size());
  EXPECT_EQ(suites.children[0].children[0].attributes.at("classname"), "rooms.a_b_obj");
  EXPECT_EQ(suites.children[1].attributes.at("failures"), "0");
  EXPECT_EQ(suites.attributes.at("tests"), std::to_string(2 * validate::all_rules().size()));
  EXPECT_EQ(suites.attributes.at("failures"), "1");
}

TEST(Junit, FailuresNameTheirPlaces) {
  const XmlElement suites = suites_of(report_on({broken_input()}));
  const XmlElement t_vertex = case_of(suites.children[0], "RL201");
  ASSERT_EQ(outcome_of(t_vertex), "failure");
  EXPECT_EQ(t_vertex.attributes.at("line"), "120");
  EXPECT_EQ(t_vertex.children[0].attributes.at("message"), "2 errors");
  EXPECT_THAT(t_vertex.children[0].text,
              HasSubstr("room.obj:9: 3 T-vertices on an edge of \"floor\" at (10, 0, 3.5)\n"));
}

TEST(Junit, OnlyWhatFailsTheRunFails) {
  Report report = report_on({broken_input()});
  EXPECT_EQ(outcome_of(case_of(suites_of(report).children[0], "RL101")), "system-out");
  report.fail_on = FailOn::Note;
  EXPECT_EQ(outcome_of(case_of(suites_of(report).children[0], "RL101")), "failure");
  report.fail_on = FailOn::Never;
  EXPECT_EQ(outcome_of(case_of(suites_of(report).children[0], "RL201")), "system-out");
}

TEST(Junit, RulesThatDidNotRunAreSkipped) {
  Report report = report_on({samples::clean_input()});
  report.inputs[0].result.checked = {validate::find_rule("RL201")};
  const XmlElement suites = suites_of(report);
  EXPECT_EQ(outcome_of(case_of(suites.children[0], "RL201")), "pass");
  EXPECT_EQ(outcome_of(case_of(suites.children[0], "RL210")), "skipped");
  EXPECT_EQ(suites.attributes.at("skipped"), std::to_string(validate::all_rules().size() - 1));
}

TEST(Junit, UnreadableAndHalfJudgedModelsAreErrors) {
  Report report = report_on({samples::unreadable_input(), broken_input()});
  report.inputs[1].result.incomplete = "too dense";
  const XmlElement suites = suites_of(report);
  EXPECT_EQ(outcome_of(case_of(suites.children[0], "RL001")), "error");
  EXPECT_EQ(case_of(suites.children[1], "judged").children[0].text, "too dense");
  EXPECT_EQ(suites.attributes.at("errors"), "2");
}

TEST(Junit, HostileNamesStayText) {
  const XmlElement suites = suites_of(report_on({samples::hostile_input()}));
  const XmlElement t_vertex = case_of(suites.children[0], "RL201");
  EXPECT_THAT(t_vertex.children[0].text, HasSubstr("=a\"b'c<d>&]]>|`*_[x](y) ::error::\uFFFD[31m\uFFFD\uFFFD@you"));
  EXPECT_THAT(t_vertex.attributes.at("file"), HasSubstr("c<d>&]]>"));
}

TEST(Junit, TimesOnlyWhereAskedFor) {
  EXPECT_THAT(junit(report_on({broken_input()})), Not(HasSubstr("time=")));
  EXPECT_EQ(suites_of(report_on({broken_input()}), true).children[0].attributes.at("time"), "0.750000");
}

}  // namespace
}  // namespace rad::report
