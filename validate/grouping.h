// From violations to findings: like violations of the same participants that hang together become one finding.
#pragma once

#include <vector>

#include "validate/context.h"
#include "validate/lint.h"

namespace rad::validate {

/// What a rule's findings weigh at a stage.
struct Severities {
  scene::Severity usual = scene::Severity::Error;
  scene::Severity grave = scene::Severity::Error;  ///< where a violation is grave
};

/// Findings of one rule. Participants are the objects and materials of a violation's faces. Violations with equal
/// participants are one finding where they share a face or a nonzero cluster key; with `group` false each stands
/// alone. The result does not depend on the order of violations.
std::vector<scene::Finding> group_violations(const Rule& rule, const Severities& severities, const Context& context,
                                             const Violations& violations, bool group);

/// The finding of a rule that reports what the reader could not take over.
scene::Finding finding_of_issue(const Rule& rule, scene::Severity severity, const scene::Scene& scene,
                                const scene::ReadIssue& issue);

/// Canonical order: severity, rule, file, largest measure, place, message, fingerprint.
void sort_findings(std::vector<scene::Finding>& findings);

/// Makes fingerprints of one report distinct: the second of equal ones gets "-2" and so on.
void number_equal_fingerprints(std::vector<scene::Finding>& findings);

}  // namespace rad::validate
