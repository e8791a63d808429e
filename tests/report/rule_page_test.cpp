#include "report/rule_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/text_layout.h"
#include "report/units.h"
#include "validate/registry.h"

namespace rad::report {
namespace {

using testing::HasSubstr;

const validate::Rule& t_vertex() { return *validate::find_rule("RL201"); }

TEST(RulePage, MarkdownHasAllParts) {
  for (const validate::Rule* rule : validate::all_rules()) {
    const std::string page = rule_markdown(*rule);
    for (const char* heading : {"## What\n", "## Why it matters\n", "## How it is tested\n", "## Fix\n",
                                "## In your modeller\n", "## Limits\n", "## Examples\n"}) {
      EXPECT_THAT(page, HasSubstr(heading)) << rule->id;
    }
    EXPECT_EQ(page.find("Source: ."), std::string::npos) << rule->id;
    const std::string examples = "corpus/rules/" + std::string(rule->id) + "-" + std::string(rule->alias);
    EXPECT_EQ(page.find(examples) == std::string::npos, rule->of_tool) << rule->id;
    EXPECT_EQ(std::filesystem::exists(std::filesystem::path(RAD_SOURCE_DIR) / examples), !rule->of_tool) << rule->id;
  }
}

TEST(RulePage, SeverityOfEveryStage) {
  const std::string page = rule_markdown(t_vertex());
  EXPECT_THAT(page,
              HasSubstr("| `model` | error |\n| `preprocess` | note |\n| `solve` | error |\n| `display` | error |"));
  EXPECT_THAT(rule_markdown(*validate::find_rule("RL101")), HasSubstr("| `preprocess` | off |"));
}

TEST(RulePage, TextFitsTheWidth) {
  for (const validate::Rule* rule : validate::all_rules()) {
    for (const std::string& page : {rule_text(*rule, 80), rules_text(validate::all_rules(), 80)}) {
      std::istringstream stream(page);
      for (std::string line; std::getline(stream, line);) EXPECT_LE(columns(line), 80U) << line;
    }
  }
}

TEST(RulePage, JsonOfAllRules) {
  const auto rules = nlohmann::json::parse(rules_json(validate::all_rules()));
  ASSERT_EQ(rules.size(), validate::all_rules().size());
  const auto rule = nlohmann::json::parse(rule_json(t_vertex()));
  EXPECT_EQ(rule["id"], "RL201");
  EXPECT_EQ(rule["requirement"], "2a");
  EXPECT_EQ(rule["severity"]["preprocess"], "note");
  EXPECT_FALSE(rule["doc"]["why"].get<std::string>().empty());
}

TEST(RulePage, ListsLinkToPages) {
  const std::string index = rules_markdown(validate::all_rules());
  for (const validate::Rule* rule : validate::all_rules()) {
    EXPECT_THAT(index, HasSubstr("](" + std::string(rule->id) + ".md)"));
  }
}

TEST(Units, Names) {
  EXPECT_EQ(metres_in("ft"), 0.3048);
  EXPECT_EQ(metres_in("yd"), std::nullopt);
  EXPECT_EQ(unit_label(0.001), "mm");
  EXPECT_EQ(unit_label(0.9144), "units of 0.9144 m");
  EXPECT_EQ(unit_label(std::nullopt), "units");
}

}  // namespace
}  // namespace rad::report
