#include "validate/tool_finding.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "validate/registry.h"

namespace rad::validate {
namespace {

scene::Where at_line(std::uint64_t line) {
  scene::Where where;
  where.file = "radlint-baseline.json";
  where.line = line;
  return where;
}

TEST(ToolFinding, SaysWhatAndWhere) {
  const scene::Finding finding =
      tool_finding(*find_rule("RL903"), "the suppression of RL201 matches nothing", at_line(7));
  EXPECT_EQ(finding.rule, "RL903");
  EXPECT_EQ(finding.alias, "unused-suppression");
  EXPECT_EQ(finding.severity, scene::Severity::Warning);
  EXPECT_EQ(finding.message, "the suppression of RL201 matches nothing");
  EXPECT_EQ(finding.where.line, 7u);
  EXPECT_FALSE(finding.fingerprint.empty());
}

TEST(ToolFinding, IsForRulesAboutTheRunOnly) {
  EXPECT_THROW(tool_finding(*find_rule("RL201"), "", {}), std::logic_error);
  for (const char* id : {"RL901", "RL902", "RL903", "RL904", "RL905"}) {
    const Rule* rule = find_rule(id);
    ASSERT_NE(rule, nullptr) << id;
    EXPECT_TRUE(rule->of_tool) << id;
  }
}

}  // namespace
}  // namespace rad::validate
