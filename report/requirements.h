// The paper's requirements 1a to 3a as a run answered them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "report/report.h"
#include "validate/rule.h"

namespace rad::report {

enum class RequirementStatus : std::uint8_t {
  Pass,
  Note,
  Warning,
  Fail,
  NotAsked,    ///< the stage does not ask for it
  NotChecked,  ///< no rule of it ran: left out by the user, nothing to judge, or not tested by this version
};

struct RequirementSummary {
  validate::Requirement requirement = validate::Requirement::SolidModel;
  RequirementStatus status = RequirementStatus::NotChecked;
  Counts counts;
};

/// 1a to 3a in order, the worst over all inputs.
std::vector<RequirementSummary> requirement_summaries(std::span<const InputReport> inputs, validate::Stage stage);

std::string_view name(RequirementStatus status);

}  // namespace rad::report
