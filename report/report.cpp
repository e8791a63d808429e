#include "report/report.h"

#include <algorithm>
#include <map>
#include <set>

namespace rad::report {

std::string_view tool_version() { return RAD_VERSION; }

void Counts::add(scene::Severity severity, std::uint64_t findings) {
  switch (severity) {
    case scene::Severity::Error:
      errors += findings;
      break;
    case scene::Severity::Warning:
      warnings += findings;
      break;
    case scene::Severity::Note:
      notes += findings;
      break;
  }
}

Counts& Counts::operator+=(const Counts& other) {
  errors += other.errors;
  warnings += other.warnings;
  notes += other.notes;
  return *this;
}

Counts counts(const InputReport& input) {
  Counts sum;
  for (const scene::Finding& finding : input.result.findings) sum.add(finding.severity);
  for (const Unlisted& rest : input.unlisted) sum.add(rest.severity, rest.findings);
  return sum;
}

Counts counts(const Report& report) {
  Counts sum;
  for (const InputReport& input : report.inputs) sum += counts(input);
  return sum;
}

std::uint64_t known_findings(const Report& report) {
  std::uint64_t sum = 0;
  for (const InputReport& input : report.inputs) sum += input.known.size();
  return sum;
}

std::uint64_t suppressed_findings(const InputReport& input) {
  std::uint64_t sum = 0;
  for (const validate::SuppressionUse& use : input.result.suppressions) sum += use.findings;
  return sum;
}

std::uint64_t suppressed_findings(const Report& report) {
  std::uint64_t sum = 0;
  for (const InputReport& input : report.inputs) sum += suppressed_findings(input);
  return sum;
}

bool reaches(const Counts& counts, FailOn fail_on) {
  switch (fail_on) {
    case FailOn::Error:
      return counts.errors > 0;
    case FailOn::Warning:
      return counts.errors + counts.warnings > 0;
    case FailOn::Note:
      return counts.errors + counts.warnings + counts.notes > 0;
    case FailOn::Never:
      return false;
  }
  return false;
}

std::vector<Unlisted> unlisted_findings(const InputReport& input, std::size_t max_issues) {
  std::map<std::pair<std::string_view, scene::Severity>, Unlisted> rest;
  const auto add = [&](const Unlisted& more) {
    Unlisted& sum = rest.try_emplace({more.rule, more.severity}, Unlisted{more.rule, more.requirement, more.severity})
                        .first->second;
    sum.places += more.places;
    sum.findings += more.findings;
  };
  for (const Unlisted& more : input.unlisted) add(more);
  std::map<std::string_view, std::size_t> listed;
  for (const scene::Finding& finding : input.result.findings) {
    if (max_issues == 0 || ++listed[finding.rule] <= max_issues) continue;
    add({finding.rule, finding.requirement, finding.severity, finding.count, 1});
  }
  std::vector<Unlisted> sorted;
  for (const auto& [key, sum] : rest) sorted.push_back(sum);
  return sorted;
}

std::vector<RuleTotal> rule_totals(const Report& report) {
  std::map<std::string_view, RuleTotal> totals;
  const auto add = [&](std::string_view rule, scene::Severity severity, std::uint64_t places, std::uint64_t findings) {
    RuleTotal& total = totals.try_emplace(rule, RuleTotal{rule}).first->second;
    total.severity = std::max(total.severity, severity);
    total.places += places;
    total.findings += findings;
  };
  for (const InputReport& input : report.inputs) {
    for (const scene::Finding& finding : input.result.findings) add(finding.rule, finding.severity, finding.count, 1);
    for (const Unlisted& rest : input.unlisted) add(rest.rule, rest.severity, rest.places, rest.findings);
    for (const Unlisted& rest : unlisted_findings(input, report.max_issues)) totals.at(rest.rule).truncated = true;
  }
  std::vector<RuleTotal> sorted;
  for (const auto& [rule, total] : totals) sorted.push_back(total);
  return sorted;
}

std::vector<const validate::Rule*> checked_rules(const Report& report) {
  std::set<const validate::Rule*> checked;
  for (const InputReport& input : report.inputs)
    checked.insert(input.result.checked.begin(), input.result.checked.end());
  std::vector<const validate::Rule*> ordered;
  for (const validate::Rule* rule : validate::all_rules()) {
    if (checked.contains(rule)) ordered.push_back(rule);
  }
  return ordered;
}

std::string_view name(FailOn fail_on) {
  switch (fail_on) {
    case FailOn::Error:
      return "error";
    case FailOn::Warning:
      return "warning";
    case FailOn::Note:
      return "note";
    case FailOn::Never:
      return "never";
  }
  return "error";
}

std::string_view name(ValueSource source) {
  switch (source) {
    case ValueSource::Unknown:
      return "unknown";
    case ValueSource::Declared:
      return "declared";
    case ValueSource::Given:
      return "given";
  }
  return "unknown";
}

std::string_view name(scene::UpAxis up) {
  switch (up) {
    case scene::UpAxis::Unknown:
      return "";
    case scene::UpAxis::Y:
      return "y";
    case scene::UpAxis::Z:
      return "z";
  }
  return "";
}

}  // namespace rad::report
