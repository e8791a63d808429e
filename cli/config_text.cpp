// `radlint config` as text.
#include <fmt/format.h>

#include <algorithm>

#include "cli/config_view.h"
#include "report/printable.h"

namespace rad::cli {

namespace {

constexpr std::size_t kValueColumns = 28;

std::string line_of(std::string_view name, std::string_view value, std::string_view origin) {
  return report::printable(fmt::format("{:<14}{:<{}}  {}", name, value, kValueColumns, origin)) + '\n';
}

bool is_as_usual(const config::RuleInForce& rule) {
  return rule.on && rule.on_origin.source.empty() && !rule.severity && rule.parameters.empty();
}

void append_rule(const config::RuleInForce& it, std::string& out) {
  const std::string name = fmt::format("  {} {}", it.rule->id, it.rule->alias);
  out += fmt::format("{:<42}  {}\n", name + (it.on ? "" : "  off"), it.on_origin.text());
  if (it.severity) {
    out += fmt::format("    {:<38}  {}\n", fmt::format("severity = {}", scene::name(it.severity->value)),
                       it.severity->origin.text());
  }
  for (const auto& [key, value] : it.parameters) {
    const validate::Parameter* parameter = validate::find_parameter(*it.rule, key);
    const std::string text = fmt::format("{} = {} {} (usually {})", key, value.value,
                                         parameter->unit == "1" ? "" : parameter->unit, parameter->standard);
    out += fmt::format("    {:<38}  {}\n", text, value.origin.text());
  }
}

std::string patterns_text(const scene::NamePatterns& names) {
  std::string text;
  for (const std::string& object : names.objects) text += (text.empty() ? "" : ", ") + object;
  for (const std::string& material : names.materials) text += (text.empty() ? "" : ", ") + ("material " + material);
  return text;
}

void append_objects(const config::ObjectsEntry& entry, std::string& out) {
  std::string what;
  for (const std::string& rule : entry.ignore) what += " ignore " + rule;
  for (const auto& [rule, severity] : entry.severities) what += fmt::format(" {} {}", rule->id, scene::name(severity));
  for (const auto& [rule, values] : entry.thresholds) {
    for (const auto& [name, value] : values) what += fmt::format(" {} {} = {}", rule->id, name, value);
  }
  out += report::printable(fmt::format("  {:<40}  {}", patterns_text(entry.names) + ":" + what, entry.origin.text())) +
         '\n';
}

}  // namespace

std::string config_text(const ConfigView& view) {
  std::string out = report::printable(view.path) + '\n';
  if (view.files.empty()) out += "  no radlint.toml speaks of it\n";
  for (const std::string& file : view.files) out += "  " + report::printable(file) + '\n';
  out += '\n';
  for (const SettingView& setting : view.settings) {
    out += line_of(setting.name, setting.value.empty() ? "-" : setting.value, setting.origin);
  }
  for (const SettingView& pattern : view.exclude) out += line_of(pattern.name, pattern.value, pattern.origin);
  const auto& rules = view.in_force.rules;
  const auto on = std::ranges::count_if(rules, &config::RuleInForce::on);
  out += fmt::format("\nrules: {} of {}; those not listed are as usual\n", on, rules.size());
  for (const config::RuleInForce& rule : rules) {
    if (!is_as_usual(rule)) append_rule(rule, out);
  }
  if (!view.in_force.objects.empty()) out += "\nobjects\n";
  for (const config::ObjectsEntry* entry : view.in_force.objects) append_objects(*entry, out);
  return out;
}

}  // namespace rad::cli
