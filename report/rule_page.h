// The page of a rule and the list of all rules, made of the text that stands with the rule itself.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "validate/rule.h"

namespace rad::report {

/// For a terminal of `width` columns.
std::string rule_text(const validate::Rule& rule, std::size_t width = 80);

/// Pictures of a model that breaks the rule and of one that keeps it, as paths from the page; empty for none.
struct PageExamples {
  std::string fail;
  std::string pass;
};
std::string rule_markdown(const validate::Rule& rule, const PageExamples& examples = {});

std::string rule_json(const validate::Rule& rule);

/// One line, row or entry for each rule.
std::string rules_text(std::span<const validate::Rule* const> rules, std::size_t width = 80);
std::string rules_markdown(std::span<const validate::Rule* const> rules);
std::string rules_json(std::span<const validate::Rule* const> rules);

/// Folder of the rule's example files below corpus/rules/: "RL201-t-vertex".
std::string fixture_folder(const validate::Rule& rule);

}  // namespace rad::report
