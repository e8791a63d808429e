#include "validate/rule_run.h"

#include <algorithm>
#include <iterator>

#include "validate/threshold_zones.h"

namespace rad::validate {

namespace {

constexpr std::size_t kUsual = SIZE_MAX;

void append(std::vector<scene::Finding> from, std::vector<scene::Finding>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

RuleRun::RuleRun(Context& context, const LintOptions& options)
    : context_(context), options_(options), waivers_(options.waivers, context.scene) {
  for (const NamedSeverity& named : options.named_severities) named_.emplace_back(named.names, context.scene);
}

std::optional<Severities> RuleRun::severities_of(const Rule& rule) const {
  if (const auto given = options_.severities.find(&rule); given != options_.severities.end()) {
    return Severities{given->second, given->second};
  }
  auto usual = severity_at(rule, options_.stage);
  if (!usual) return std::nullopt;
  if (rule.note_where_triangles_only && context_.scene.triangles_only) usual = scene::Severity::Note;
  return Severities{*usual, options_.light ? *grave_severity_at(rule, options_.stage) : *usual};
}

bool RuleRun::run(const Rule& rule) {
  const auto severities = rule.of_tool ? std::nullopt : severities_of(rule);
  if (!severities) return false;
  checked_.push_back(&rule);
  if (rule.reports) {
    run_issues(rule, *severities);
  } else {
    run_check(rule, *severities);
  }
  return true;
}

std::size_t RuleRun::weight_of(const Rule& rule, const Violation& violation) const {
  const auto fits = [&](std::size_t i) {
    return options_.named_severities[i].rule == &rule && std::ranges::any_of(violation.faces, [&](FaceId face) {
             return face != kNoFace && named_[i].has(context_.scene.faces[face]);
           });
  };
  for (std::size_t i = named_.size(); i-- > 0;) {
    if (fits(i)) return i;
  }
  return kUsual;
}

void RuleRun::run_check(const Rule& rule, const Severities& severities) {
  const ThresholdZones zones(rule, options_, context_.scene);
  for (std::size_t zone = 0; zone < zones.values().size(); ++zone) {
    context_.parameters = zones.values()[zone];
    Violations violations;
    rule.check(context_, violations);
    std::erase_if(violations.items, [&](const Violation& violation) { return zones.zone_of(violation) != zone; });
    report_violations(rule, severities, violations);
  }
  context_.parameters = options_.parameters;
}

void RuleRun::report_violations(const Rule& rule, const Severities& severities, const Violations& violations) {
  const bool some_named =
      std::ranges::any_of(options_.named_severities, [&](const NamedSeverity& named) { return named.rule == &rule; });
  if (!some_named && !waivers_.speak_of(rule)) {
    return report(group_violations(rule, severities, context_, violations, options_.group));
  }
  ByWeight reported;
  std::map<std::size_t, Violations> silenced;
  for (const Violation& violation : violations.items) {
    const auto waiver = waivers_.silencing(rule, violation);
    (waiver ? silenced[*waiver] : reported[weight_of(rule, violation)]).add(violation);
  }
  for (const auto& [weight, some] : reported) {
    const auto given = weight == kUsual ? std::nullopt : std::optional(options_.named_severities[weight].severity);
    const Severities weights = given ? Severities{*given, *given} : severities;
    report(group_violations(rule, weights, context_, some, options_.group));
  }
  for (const auto& [waiver, some] : silenced) {
    suppress(waiver, group_violations(rule, severities, context_, some, options_.group));
  }
}

void RuleRun::run_issues(const Rule& rule, const Severities& severities) {
  for (const scene::ReadIssue& issue : context_.issues.all()) {
    if (issue.kind != rule.reports) continue;
    std::vector<scene::Finding> findings{finding_of_issue(rule, severities.usual, context_.scene, issue)};
    if (const auto waiver = waivers_.silencing(rule, issue)) {
      suppress(*waiver, std::move(findings));
    } else {
      report(std::move(findings));
    }
  }
}

void RuleRun::report(std::vector<scene::Finding> findings) { append(std::move(findings), findings_); }

void RuleRun::suppress(std::size_t waiver, std::vector<scene::Finding> findings) {
  append(std::move(findings), suppressed_[waiver]);
}

void RuleRun::finish(LintResult& result) {
  for (auto& [waiver, findings] : suppressed_) {
    SuppressionUse use = waivers_.use_of(waiver);
    sort_findings(findings);
    number_equal_fingerprints(findings);
    for (scene::Finding& finding : findings) {
      ++use.findings;
      use.places += finding.count;
      result.suppressed.push_back({std::move(finding), result.suppressions.size()});
    }
    result.suppressions.push_back(std::move(use));
  }
  append(std::move(findings_), result.findings);
  append(waivers_.complaints(options_, checked_, result.incomplete.empty()), result.findings);
  result.checked = std::move(checked_);
}

}  // namespace rad::validate
