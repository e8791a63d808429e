// The rules there are, and choosing among them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validate/rule.h"

namespace rad::validate {

/// Every rule, in the order of rules.def: lower levels first.
std::span<const Rule* const> all_rules();

/// By id or alias; null where there is none.
const Rule* find_rule(std::string_view id_or_alias);

/// Rules by id prefix ("RL2"), id, alias or "ALL"; empty where nothing matches.
std::vector<const Rule*> matching_rules(std::string_view selector);

/// The id or alias nearest to a mistyped selector, for "did you mean".
std::string_view nearest_selector(std::string_view selector);

/// Rules that remain of all after `select` (empty: all) and `ignore`. A selector that matches nothing is named.
struct RuleChoice {
  std::vector<const Rule*> rules;
  std::string unknown_selector;
};
RuleChoice choose_rules(std::span<const std::string> select, std::span<const std::string> ignore);

}  // namespace rad::validate
