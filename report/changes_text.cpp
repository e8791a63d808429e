#include "report/changes_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "validate/registry.h"

namespace rad::report {
namespace {

constexpr std::size_t kRuleWidth = 34;

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kKindWords{{
    {"moved", "faces moved"},
    {"cut", "faces of the input cut"},
    {"divided", "faces that got vertices along their edges"},
    {"merged", "faces merged from several"},
    {"turned", "faces turned"},
    {"won", "faces that others lay in"},
    {"removed", "faces of the input of which nothing is left"},
}};

std::string words_for(const std::string& kind) {
  const auto* const found = std::ranges::find(kKindWords, kind, &decltype(kKindWords)::value_type::first);
  return found == kKindWords.end() ? kind : std::string(found->second);
}

struct BeforeAfter {
  std::uint64_t before = 0;
  std::uint64_t after = 0;
};

std::map<std::string_view, BeforeAfter> places_by_rule(const RepairReport& report) {
  std::map<std::string_view, BeforeAfter> rules;
  for (const RuleTotal& total : rule_totals(report.before)) rules[total.rule].before = total.places;
  if (!report.after) return rules;
  for (const RuleTotal& total : rule_totals(*report.after)) rules[total.rule].after = total.places;
  return rules;
}

void append_rules(std::string& out, const RepairReport& report, const Paint& paint) {
  out += fmt::format("\n{}\n", paint(Ink::Bold, "places by rule, before and after"));
  for (const auto& [id, count] : places_by_rule(report)) {
    const validate::Rule* rule = validate::find_rule(id);
    const std::string name = fmt::format("{} {}", id, rule == nullptr ? "" : rule->alias);
    out += fmt::format("  {} {:>9} {:>9}\n", padded(name, kRuleWidth), count.before, count.after);
  }
}

void append_place(std::string& out, const ChangePlace& place) {
  out += fmt::format("    {}  at ({}, {}, {})", printable(place.face.ref), short_number(place.at.x),
                     short_number(place.at.y), short_number(place.at.z));
  if (place.distance > 0) out += fmt::format("  by {}", short_number(place.distance));
  out += '\n';
}

void append_kind(std::string& out, const Change& change) {
  out += fmt::format("  {} {:>9}\n", padded(words_for(change.kind), kRuleWidth + 10), change.count);
  for (const ChangePlace& place : change.places) append_place(out, place);
  if (change.count > change.places.size()) out += "    …\n";
}

}  // namespace

void append_changes(std::string& out, const RepairReport& report, const Paint& paint, std::size_t width) {
  append_rules(out, report, paint);
  if (!report.changes) return;
  const Changes& changes = *report.changes;
  out += fmt::format("\n{}\n", paint(Ink::Bold, "changes"));
  if (changes.kinds.empty()) out += "  none\n";
  for (const Change& change : changes.kinds) append_kind(out, change);
  append_wrapped(out,
                 fmt::format("the result is nowhere farther than {} from the input; corners and middles of the "
                             "input are at most {} from the result",
                             short_number(changes.result_to_input), short_number(changes.input_to_result)),
                 2, width);
}

void append_contracts(std::string& out, const std::vector<ContractCheck>& checks, const Paint& paint) {
  out += fmt::format("\n{}\n", paint(Ink::Bold, "contracts (Table 2)"));
  for (const ContractCheck& check : checks) {
    out += fmt::format("  {} {} {} {:>7} {:>7}  {}\n", padded(check.stage, 9), check.requirement,
                       padded(check.cell, 9), check.before, check.after,
                       check.holds ? paint(Ink::Green, "holds") : paint(Ink::Red, "BROKEN"));
  }
}

}  // namespace rad::report
