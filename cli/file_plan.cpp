#include "cli/file_plan.h"

#include <fmt/format.h>

namespace rad::cli {

std::string settings_text(const FilePlan& plan) {
  const validate::LintOptions& lint = plan.lint;
  std::string text = fmt::format("{}\nstage {} group {}\n", plan.path, validate::name(lint.stage), lint.group);
  if (lint.tolerance) {
    text += fmt::format("tolerance {} {}\n", lint.tolerance->value, static_cast<int>(lint.tolerance->measure));
  }
  if (plan.model.metres_per_unit) text += fmt::format("unit {}\n", *plan.model.metres_per_unit);
  if (plan.model.reading.level_of_detail) text += fmt::format("lod {}\n", *plan.model.reading.level_of_detail);
  if (plan.model.reading.allow_commands) text += "commands\n";
  text += fmt::format("up {}\n", report::name(plan.model.up));
  for (const validate::Rule* rule : lint.rules) text += fmt::format("rule {}\n", rule->id);
  return text;
}

}  // namespace rad::cli
