#include "validate/registry.h"

#include <algorithm>

#include "validate/edit_distance.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr const Rule* kRules[] = {
#define RAD_RULE(name) &name,
#include "validate/rules.def"
#undef RAD_RULE
};

// "RL", then digits: a whole id or the beginning of one.
bool is_prefix(std::string_view selector) {
  return selector.size() >= 2 && selector.starts_with("RL") &&
         std::all_of(selector.begin() + 2, selector.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::span<const Rule* const> all_rules() { return kRules; }

const Rule* find_rule(std::string_view id_or_alias) {
  for (const Rule* rule : kRules) {
    if (rule->id == id_or_alias || rule->alias == id_or_alias) return rule;
  }
  return nullptr;
}

std::vector<const Rule*> matching_rules(std::string_view selector) {
  std::vector<const Rule*> matches;
  for (const Rule* rule : kRules) {
    const bool by_prefix = is_prefix(selector) && rule->id.starts_with(selector);
    if (selector == "ALL" || by_prefix || rule->alias == selector) matches.push_back(rule);
  }
  return matches;
}

std::string_view nearest_selector(std::string_view selector) {
  std::string_view nearest;
  std::size_t best = SIZE_MAX;
  for (const Rule* rule : kRules) {
    for (const std::string_view candidate : {rule->id, rule->alias}) {
      const std::size_t distance = edit_distance(selector, candidate);
      if (distance < best) {
        best = distance;
        nearest = candidate;
      }
    }
  }
  return nearest;
}

RuleChoice choose_rules(std::span<const std::string> select, std::span<const std::string> ignore) {
  RuleChoice choice;
  std::vector<const Rule*> wanted, unwanted;
  const auto collect = [&](std::span<const std::string> selectors, std::vector<const Rule*>& into) {
    for (const std::string& selector : selectors) {
      const auto matches = matching_rules(selector);
      if (matches.empty() && choice.unknown_selector.empty()) choice.unknown_selector = selector;
      into.insert(into.end(), matches.begin(), matches.end());
    }
  };
  collect(select, wanted);
  collect(ignore, unwanted);
  const auto contains = [](const std::vector<const Rule*>& rules, const Rule* rule) {
    return std::find(rules.begin(), rules.end(), rule) != rules.end();
  };
  for (const Rule* rule : kRules) {
    if ((select.empty() || contains(wanted, rule)) && !contains(unwanted, rule)) choice.rules.push_back(rule);
  }
  return choice;
}

}  // namespace rad::validate
