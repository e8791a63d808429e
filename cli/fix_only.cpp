#include "cli/fix_only.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rad::cli {
namespace {

using scene::Filter;
using scene::FilterSet;

constexpr std::string_view kDropBadFaces = "drop-bad-faces";

// The filter that cures a rule; nothing where none does unasked.
std::optional<Filter> cure_of(const validate::Rule& rule) {
  if (rule.fix != scene::FixClass::Safe) return std::nullopt;
  const auto filter = scene::parse_filter(rule.fix_operation);
  return filter && scene::kRepairFilters.has(*filter) ? filter : std::nullopt;
}

// Isect works on what Grouper has made, and Coplanar on what Isect has (Table 2).
FilterSet with_what_it_requires(Filter filter) {
  return filter == Filter::Orient ? FilterSet{filter} : FilterSet::until(filter);
}

}  // namespace

std::string choose_filters_for_rules(FixCommand& command) {
  if (command.fix_only.empty()) return {};
  if (command.partial) return "--fix-only chooses the stages itself; leave --only and --until out";
  command.filters.remove(scene::kRepairFilters);
  for (const validate::Rule* rule : command.fix_only) {
    if (rule->fix_operation == kDropBadFaces) {
      if (!command.unsafe_fixes) return fmt::format("--fix-only: {} is cured under --unsafe-fixes only", rule->id);
      continue;
    }
    const auto cure = cure_of(*rule);
    if (!cure) return fmt::format("--fix-only: radfix has no cure for {} {}", rule->id, rule->alias);
    for (const Filter filter : scene::kFilters) {
      if (with_what_it_requires(*cure).has(filter)) command.filters.add(filter);
    }
  }
  return {};
}

std::string inseparable_rules(const FixCommand& command, std::span<const scene::Finding> found) {
  if (command.fix_only.empty()) return {};
  std::set<std::string> others;
  for (const scene::Finding& finding : found) {
    const validate::Rule* rule = validate::find_rule(finding.rule);
    if (finding.severity != scene::Severity::Error || rule == nullptr) continue;
    if (std::ranges::find(command.fix_only, rule) != command.fix_only.end()) continue;
    const auto cure = cure_of(*rule);
    if (cure && command.filters.has(*cure)) others.insert(fmt::format("{} {}", rule->id, rule->alias));
  }
  if (others.empty()) return {};
  return fmt::format("--fix-only: {} would cure {} as well; name them too, or leave --fix-only out",
                     scene::names(command.filters.common(scene::kRepairFilters)), fmt::join(others, ", "));
}

}  // namespace rad::cli
