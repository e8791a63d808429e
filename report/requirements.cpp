#include "report/requirements.h"

#include <algorithm>
#include <array>
#include <map>

#include "validate/registry.h"

namespace rad::report {

namespace {

using validate::Requirement;

constexpr std::array kRequirements = {
    Requirement::SolidModel,
    Requirement::NormalConsistency,
    Requirement::MaximalPlanarFaces,
    Requirement::NoTVertices,
    Requirement::NoImplicitIntersections,
    Requirement::NoOverlappingFaces,
    Requirement::SimpleFaces,
    Requirement::WellShapedFaces,
    Requirement::RadiatorDensity,
    Requirement::ReceiverDensity,
    Requirement::Ziplocking,
};

using CountsByCode = std::map<std::string_view, Counts>;

// In one pass: the findings of many files are too many to go through them for every requirement.
CountsByCode counts_by_code(std::span<const InputReport> inputs) {
  CountsByCode counts;
  for (const InputReport& input : inputs) {
    std::string_view last;
    Counts* sum = nullptr;
    for (const scene::Finding& finding : input.result.findings) {
      // Of one rule they stand together.
      if (sum == nullptr || finding.requirement != last) sum = &counts[last = finding.requirement];
      sum->add(finding.severity);
    }
    for (const Unlisted& rest : input.unlisted) counts[rest.requirement].add(rest.severity, rest.findings);
  }
  return counts;
}

bool asks_for(const validate::Rule& rule, Requirement requirement, validate::Stage stage) {
  return rule.requirement == requirement && validate::severity_at(rule, stage).has_value();
}

bool was_checked(const InputReport& input, Requirement requirement, validate::Stage stage) {
  if (!input.result.tolerance) return false;
  return std::ranges::any_of(input.result.checked,
                             [&](const validate::Rule* rule) { return asks_for(*rule, requirement, stage); });
}

/// Whether rules of the requirement exist and the stage leaves all of them off.
bool is_blank(Requirement requirement, validate::Stage stage) {
  bool any = false;
  for (const validate::Rule* rule : validate::all_rules()) {
    if (asks_for(*rule, requirement, stage)) return false;
    any = any || rule->requirement == requirement;
  }
  return any;
}

RequirementStatus status_of(std::span<const InputReport> inputs, Requirement requirement, const Counts& counts,
                            validate::Stage stage) {
  if (counts.errors > 0) return RequirementStatus::Fail;
  if (counts.warnings > 0) return RequirementStatus::Warning;
  if (counts.notes > 0) return RequirementStatus::Note;
  if (is_blank(requirement, stage)) return RequirementStatus::NotAsked;
  const bool checked =
      std::ranges::any_of(inputs, [&](const InputReport& input) { return was_checked(input, requirement, stage); });
  return checked ? RequirementStatus::Pass : RequirementStatus::NotChecked;
}

}  // namespace

std::vector<RequirementSummary> requirement_summaries(std::span<const InputReport> inputs, validate::Stage stage) {
  std::vector<RequirementSummary> summaries;
  CountsByCode by_code = counts_by_code(inputs);
  for (const Requirement requirement : kRequirements) {
    const Counts counts = by_code[validate::code(requirement)];
    summaries.push_back({requirement, status_of(inputs, requirement, counts, stage), counts});
  }
  return summaries;
}

std::string_view name(RequirementStatus status) {
  switch (status) {
    case RequirementStatus::Pass:
      return "pass";
    case RequirementStatus::Note:
      return "note";
    case RequirementStatus::Warning:
      return "warning";
    case RequirementStatus::Fail:
      return "fail";
    case RequirementStatus::NotAsked:
      return "not-asked";
    case RequirementStatus::NotChecked:
      return "not-checked";
  }
  return "not-checked";
}

}  // namespace rad::report
