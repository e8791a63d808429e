#include "report/report.h"

#include <algorithm>
#include <map>

namespace rad::report {

std::string_view tool_version() { return RAD_VERSION; }

void Counts::add(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::Error:
      ++errors;
      break;
    case scene::Severity::Warning:
      ++warnings;
      break;
    case scene::Severity::Note:
      ++notes;
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
  return sum;
}

Counts counts(const Report& report) {
  Counts sum;
  for (const InputReport& input : report.inputs) sum += counts(input);
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

std::vector<RuleTotal> rule_totals(const Report& report) {
  std::map<std::string_view, RuleTotal> totals;
  for (const InputReport& input : report.inputs) {
    std::map<std::string_view, std::uint64_t> here;
    for (const scene::Finding& finding : input.result.findings) {
      RuleTotal& total = totals.try_emplace(finding.rule, RuleTotal{finding.rule}).first->second;
      total.severity = std::max(total.severity, finding.severity);
      total.places += finding.count;
      ++total.findings;
      ++here[finding.rule];
    }
    for (const auto& [rule, findings] : here) {
      if (report.max_issues > 0 && findings > report.max_issues) totals.at(rule).truncated = true;
    }
  }
  std::vector<RuleTotal> sorted;
  for (const auto& [rule, total] : totals) sorted.push_back(total);
  return sorted;
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
