#include "cli/file_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace rad::cli {

namespace {

std::string text_of(const scene::NamePatterns& names) {
  return fmt::format("objects {} materials {}", names.objects, names.materials);
}

// Quoted as lists are, so that no name can look like a line of its own.
void add_waivers(const validate::LintOptions& lint, std::string& text) {
  for (const scene::Waiver& waiver : lint.waivers) {
    text += fmt::format("waiver {} {} {}\n", waiver.rules, std::vector{waiver.reason, waiver.place.file},
                        waiver.place.line);
    text += text_of(waiver.names) + '\n';
  }
}

void add_severities(const validate::LintOptions& lint, std::string& text) {
  std::map<std::string_view, scene::Severity> by_id;
  for (const auto& [rule, severity] : lint.severities) by_id[rule->id] = severity;
  for (const auto& [id, severity] : by_id) text += fmt::format("severity {} {}\n", id, scene::name(severity));
  for (const validate::NamedSeverity& named : lint.named_severities) {
    text += fmt::format("severity {} {} {}\n", named.rule->id, scene::name(named.severity), text_of(named.names));
  }
}

}  // namespace

std::string settings_text(const FileSettings& settings) {
  const validate::LintOptions& lint = settings.lint;
  std::string text = fmt::format("stage {} group {}\n", validate::name(lint.stage), lint.group);
  if (lint.tolerance) {
    text += fmt::format("tolerance {} {}\n", lint.tolerance->value, static_cast<int>(lint.tolerance->measure));
  }
  const ModelOptions& model = settings.model;
  if (model.metres_per_unit) text += fmt::format("unit {}\n", *model.metres_per_unit);
  if (model.reading.level_of_detail) text += fmt::format("lod {}\n", *model.reading.level_of_detail);
  if (model.reading.allow_commands) text += "commands\n";
  text += fmt::format("up {}\n", report::name(model.up));
  for (const validate::Rule* rule : lint.rules) {
    text += fmt::format("rule {}\n", rule->id);
    for (const validate::Parameter& parameter : rule->parameters) {
      text += fmt::format("{} {}\n", parameter.name, lint.parameters.of(*rule, parameter.name));
    }
  }
  add_severities(lint, text);
  for (const validate::NamedThreshold& named : lint.named_thresholds) {
    text += fmt::format("threshold {} {} {} {}\n", named.rule->id, named.parameter, named.value, text_of(named.names));
  }
  add_waivers(lint, text);
  return text;
}

}  // namespace rad::cli
