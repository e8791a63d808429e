// What an author asks not to be told of: what it silences, what remains, and what comes to nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "readers/reader.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

using testing::HasSubstr;

// Two boxes, each with its last face turned: line 16 in "left", line 32 in "right".
std::string two_boxes() {
  std::string text;
  for (const int shift : {0, 10}) {
    const std::string low = std::to_string(shift), high = std::to_string(shift + 1);
    text += shift == 0 ? "o left\n" : "o right\n";
    for (const char* z : {" 0\n", " 1\n"}) {
      for (const std::string& corner : {low + " 0", high + " 0", high + " 1", low + " 1"}) text += "v " + corner + z;
    }
    text += "usemtl " + std::string(shift == 0 ? "oak" : "glass") + "\n";
    text += "f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -1 -4 -8 -5\n";
  }
  return text;
}

std::string with_line(std::string text, const std::string& before, const std::string& line) {
  return text.insert(text.find(before), line);
}

LintResult judge(const std::string& text, LintOptions options = {}) {
  readers::Input input;
  input.path = "boxes.obj";
  input.bytes = text;
  const readers::ReadResult read = readers::read_bytes(input);
  options.waivers.insert(options.waivers.begin(), read.waivers.begin(), read.waivers.end());
  return lint(read.scene, read.issues, options);
}

std::vector<std::string> of_rule(const LintResult& result, std::string_view id) {
  std::vector<std::string> texts;
  for (const scene::Finding& finding : result.findings) {
    if (finding.rule == id) texts.push_back(finding.message);
  }
  return texts;
}

scene::Waiver by_name(const std::string& rule, scene::NamePatterns names) {
  scene::Waiver waiver;
  waiver.rules = {rule};
  waiver.scope = scene::WaiverScope::Names;
  waiver.names = std::move(names);
  waiver.origin = scene::WaiverOrigin::Configuration;
  return waiver;
}

TEST(Waivers, WithoutThemBothBoxesAreReported) {
  const LintResult result = judge(two_boxes());
  EXPECT_EQ(of_rule(result, "RL110").size(), 2U);
  EXPECT_TRUE(result.suppressions.empty());
  EXPECT_TRUE(result.suppressed.empty());
}

TEST(Waivers, CommentBeforeAnObjectSilencesIt) {
  const LintResult result = judge(with_line(two_boxes(), "o right", "# radlint: ignore[RL110] as built\n"));
  ASSERT_EQ(of_rule(result, "RL110").size(), 1U);
  EXPECT_THAT(of_rule(result, "RL110")[0], HasSubstr("left"));
  ASSERT_EQ(result.suppressions.size(), 1U);
  const SuppressionUse& use = result.suppressions[0];
  EXPECT_EQ(use.reason, "as built");
  EXPECT_EQ(use.origin, scene::WaiverOrigin::Model);
  EXPECT_EQ(use.place.file, "boxes.obj");
  EXPECT_EQ(use.place.line, 17U);
  EXPECT_EQ(use.findings, 1U);
  EXPECT_GE(use.places, 1U);
  ASSERT_EQ(result.suppressed.size(), 1U);
  EXPECT_EQ(result.suppressed[0].finding.rule, "RL110");
  EXPECT_TRUE(of_rule(result, "RL903").empty());
}

TEST(Waivers, WholeFilesAndPrefixes) {
  const LintResult result = judge("# radlint: ignore-file[RL1, t-vertex]\n" + two_boxes());
  EXPECT_TRUE(of_rule(result, "RL110").empty());
  ASSERT_EQ(result.suppressions.size(), 1U);
  EXPECT_EQ(result.suppressions[0].findings, 2U);
  EXPECT_EQ(of_rule(result, "RL903"), std::vector<std::string>{"the suppression of t-vertex suppresses nothing"});
}

TEST(Waivers, OfAClusterTheRestRemains) {
  // Two turned faces of one box: the comment behind one of them speaks of that one alone.
  std::string text = two_boxes();
  text = text.substr(0, text.find("o right"));
  text = text.replace(text.find("f -8 -7 -3 -4\n"), 14, "f -4 -3 -7 -8 # radlint: ignore[RL110] known\n");
  LintOptions options;
  options.group = false;
  std::size_t all =
      of_rule(judge(text.substr(0, text.find(" #")) + text.substr(text.find(" known") + 6), options), "RL110").size();
  const LintResult result = judge(text, options);
  EXPECT_GT(result.suppressed.size(), 0U);
  EXPECT_GT(of_rule(result, "RL110").size(), 0U);
  EXPECT_EQ(result.suppressed.size() + of_rule(result, "RL110").size(), all);
}

TEST(Waivers, WhatSilencesNothingIsReportedWhereItStands) {
  const LintResult result = judge(with_line(two_boxes(), "o right", "# radlint: ignore[RL221] rug\n"));
  const auto found = std::ranges::find(result.findings, "RL903", &scene::Finding::rule);
  ASSERT_NE(found, result.findings.end());
  EXPECT_EQ(found->where.line, 17U);
  EXPECT_EQ(found->where.file, "boxes.obj");
  EXPECT_EQ(found->severity, scene::Severity::Warning);
}

TEST(Waivers, OfRulesThatAreNotCheckedNothingIsSaid) {
  LintOptions options;
  std::erase_if(options.rules, [](const Rule* rule) { return rule->id == "RL221"; });
  const std::string text = with_line(two_boxes(), "o right", "# radlint: ignore[RL221]\n# radlint: ignore[RL22]\n");
  EXPECT_TRUE(of_rule(judge(text, options), "RL903").empty());
  EXPECT_EQ(of_rule(judge(text), "RL903").size(), 2U);
}

TEST(Waivers, WhatIsNotUnderstoodIsReported) {
  const LintResult result = judge("# radlint: ignore-file[t-vertx]\n# radlint: ignor[RL201]\n" + two_boxes());
  EXPECT_THAT(of_rule(result, "RL905"),
              testing::UnorderedElementsAre(HasSubstr("'t-vertx', which is no rule; did you mean t-vertex?"),
                                            HasSubstr("cannot be understood")));
}

TEST(Waivers, RulesAboutTheRunAreOutOfReach) {
  const LintResult result = judge("# radlint: ignore-file[RL903]\n" + two_boxes());
  ASSERT_EQ(of_rule(result, "RL903").size(), 1U);
  EXPECT_THAT(of_rule(result, "RL903")[0], HasSubstr("about the run"));
}

TEST(Waivers, NamesOfTheConfigurationSilenceAndAreNotJudged) {
  LintOptions options;
  options.waivers = {by_name("RL110", {{"r*"}, {}}), by_name("RL221", {{"x"}, {}}), by_name("RL110", {{}, {"oak"}})};
  const LintResult result = judge(two_boxes(), options);
  EXPECT_TRUE(of_rule(result, "RL110").empty());
  EXPECT_TRUE(of_rule(result, "RL903").empty());
  EXPECT_EQ(result.suppressions.size(), 2U);
  options.waivers = {by_name("RL110", {{"right"}, {"oak"}})};
  EXPECT_EQ(of_rule(judge(two_boxes(), options), "RL110").size(), 2U) << "both lists must fit";
}

TEST(Waivers, LinesThatCouldNotBeReadAreReached) {
  std::string text = two_boxes() + "# radlint: ignore[RL002] left over\nf 1 2 99\n";
  const LintResult result = judge(text);
  EXPECT_TRUE(of_rule(result, "RL002").empty());
  EXPECT_EQ(result.suppressions.size(), 1U);
}

TEST(Severities, GivenOnesReplaceThoseOfTheStage) {
  LintOptions options;
  options.severities[find_rule("RL110")] = scene::Severity::Note;
  for (const scene::Finding& finding : judge(two_boxes(), options).findings) {
    EXPECT_TRUE(finding.rule != "RL110" || finding.severity == scene::Severity::Note);
  }
  LintOptions named;
  named.named_severities = {{{{"left"}, {}}, find_rule("RL110"), scene::Severity::Note},
                            {{{"l*"}, {}}, find_rule("RL110"), scene::Severity::Warning}};
  for (const scene::Finding& finding : judge(two_boxes(), named).findings) {
    if (finding.rule != "RL110") continue;
    const bool left = finding.where.objects == std::vector<std::string>{"left"};
    EXPECT_EQ(finding.severity, left ? scene::Severity::Warning : scene::Severity::Error);
  }
}

// Two needles of ρ about 0.09 that meet nothing.
std::string needles() {
  return "v 0 0 0\nv 10 0 0\nv 10 0.5 0\nv 0 9 0\nv 10 9 0\nv 10 9.5 0\n"
         "o left\nf 1 2 3\no right\nf 4 5 6\n";
}

// Objects whose needles are found, with the threshold that they are held against.
std::map<std::string, double> found_needles(const LintOptions& options) {
  std::map<std::string, double> found;
  for (const scene::Finding& finding : judge(needles(), options).findings) {
    if (finding.rule == "RL240") found[finding.where.objects.at(0)] = finding.measure->threshold.value_or(0);
  }
  return found;
}

TEST(Thresholds, HoldWhereTheirNamesDo) {
  using Found = std::map<std::string, double>;
  LintOptions options;
  EXPECT_EQ(found_needles(options), (Found{{"left", 0.2}, {"right", 0.2}}));
  options.named_thresholds = {{{{"left"}, {}}, find_rule("RL240"), "min-shape", 0.01}};
  EXPECT_EQ(found_needles(options), (Found{{"right", 0.2}}));
  options.named_thresholds.push_back({{{"l*"}, {}}, find_rule("RL240"), "min-shape", 0.5});
  EXPECT_EQ(found_needles(options), (Found{{"left", 0.5}, {"right", 0.2}})) << "the last of several counts";
}

TEST(Severities, RuleThatTheStageDoesNotAskForIsChecked) {
  const Rule* rule = nullptr;
  for (const Rule* it : all_rules()) {
    if (!it->of_tool && !severity_at(*it, Stage::Preprocess)) rule = it;
  }
  ASSERT_NE(rule, nullptr);
  LintOptions options;
  options.stage = Stage::Preprocess;
  const auto checked = [&] {
    const auto rules = judge(two_boxes(), options).checked;
    return std::ranges::find(rules, rule) != rules.end();
  };
  EXPECT_FALSE(checked());
  options.severities[rule] = scene::Severity::Warning;
  EXPECT_TRUE(checked());
}

TEST(Severities, OfRulesAboutTheRun) {
  LintOptions options;
  options.severities[find_rule("RL903")] = scene::Severity::Error;
  const LintResult result = judge("# radlint: ignore-file[RL221]\n" + two_boxes(), options);
  const auto found = std::ranges::find(result.findings, "RL903", &scene::Finding::rule);
  ASSERT_NE(found, result.findings.end());
  EXPECT_EQ(found->severity, scene::Severity::Error);
}

}  // namespace
}  // namespace rad::validate
