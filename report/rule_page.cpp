#include "report/rule_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "report/json_parts.h"
#include "report/text.h"
#include "report/text_layout.h"
#include "validate/stage.h"

namespace rad::report {

namespace {

using validate::Rule;
using validate::Stage;

constexpr std::array kStages = {Stage::Model, Stage::Preprocess, Stage::Solve, Stage::Display};

std::string_view severity_text(const Rule& rule, Stage stage) {
  const auto severity = validate::severity_at(rule, stage);
  return severity ? scene::name(*severity) : std::string_view("off");
}

std::string repair_text(const Rule& rule) {
  const std::string text = fix_text({rule.fix, rule.fix_operation});
  return text.empty() ? "no repair of its own" : text;
}

using Section = std::pair<std::string_view, std::string_view>;

std::vector<Section> sections_of(const Rule& rule) {
  return {{"What", rule.doc.what}, {"Why it matters", rule.doc.why},        {"How it is tested", rule.doc.how},
          {"Fix", rule.doc.fix},   {"In your modeller", rule.doc.modeller}, {"Limits", rule.doc.limits}};
}

std::string requirement_text(const Rule& rule) {
  return fmt::format("{} ({})", validate::code(rule.requirement), validate::title(rule.requirement));
}

// "min-shape = 0.2 (from 0 to 1): least scaled ρ of a face that is well shaped"
std::string parameter_text(const validate::Parameter& parameter) {
  const std::string unit = parameter.unit == "1" ? std::string() : fmt::format(" {}", parameter.unit);
  return fmt::format("{} = {}{} (from {} to {}): {}", parameter.name, parameter.standard, unit, parameter.low,
                     parameter.high, parameter.what);
}

Json json_of(const validate::Parameter& parameter) {
  Json json;
  json["name"] = parameter.name;
  json["unit"] = parameter.unit;
  json["default"] = number(parameter.standard);
  json["least"] = number(parameter.low);
  json["largest"] = number(parameter.high);
  json["what"] = parameter.what;
  return json;
}

Json json_of(const Rule& rule) {
  Json json;
  json["id"] = rule.id;
  json["alias"] = rule.alias;
  json["title"] = rule.title;
  json["requirement"] = validate::code(rule.requirement);
  json["requirementTitle"] = validate::title(rule.requirement);
  for (const Stage stage : kStages) json["severity"][std::string(validate::name(stage))] = severity_text(rule, stage);
  json["kind"] = scene::name(rule.kind);
  json["measure"] = rule.measure.name.empty() ? Json(nullptr) : Json(rule.measure.name);
  json["fix"]["class"] = scene::name(rule.fix);
  json["fix"]["op"] = rule.fix_operation.empty() ? Json(nullptr) : Json(rule.fix_operation);
  json["citation"] = rule.citation;
  json["parameters"] = Json::array();
  for (const validate::Parameter& parameter : rule.parameters) json["parameters"].push_back(json_of(parameter));
  Json& doc = json["doc"];
  doc["what"] = rule.doc.what;
  doc["why"] = rule.doc.why;
  doc["how"] = rule.doc.how;
  doc["fix"] = rule.doc.fix;
  doc["modeller"] = rule.doc.modeller;
  doc["limits"] = rule.doc.limits;
  return json;
}

std::string examples_text(const Rule& rule) {
  if (rule.of_tool) return "It is about a run: no model shows it by itself.";
  return fmt::format(
      "Files that break this rule and files that keep it: [`corpus/rules/{0}/`](../../corpus/rules/{0}/).",
      fixture_folder(rule));
}

}  // namespace

std::string fixture_folder(const Rule& rule) { return fmt::format("{}-{}", rule.id, rule.alias); }

std::string rule_text(const Rule& rule, std::size_t width) {
  std::string out = fmt::format("{} {}\n", rule.id, rule.alias);
  append_wrapped(out, rule.title, 0, width);
  out += fmt::format("\n  requirement  {}\n  severity     ", requirement_text(rule));
  for (const Stage stage : kStages) {
    out +=
        fmt::format("{}{} {}", stage == kStages.front() ? "" : ", ", validate::name(stage), severity_text(rule, stage));
  }
  out += fmt::format("\n  repair       {}\n", repair_text(rule));
  if (!rule.citation.empty()) out += fmt::format("  source       {}\n", rule.citation);
  for (const auto& [heading, body] : sections_of(rule)) {
    out += fmt::format("\n{}\n", heading);
    append_wrapped(out, body, 2, width);
  }
  if (!rule.parameters.empty()) out += fmt::format("\nIn radlint.toml, [rules.{}]\n", rule.id);
  for (const validate::Parameter& parameter : rule.parameters) append_wrapped(out, parameter_text(parameter), 2, width);
  return out;
}

std::string rule_markdown(const Rule& rule, const PageExamples& examples) {
  std::string out = fmt::format("# {} `{}`\n\n{}\n\n", rule.id, rule.alias, rule.title);
  out += fmt::format("Requirement: {}.", requirement_text(rule));
  if (!rule.citation.empty()) out += fmt::format(" Source: {}.", rule.citation);
  out += "\n\n";
  out += "| Stage | Severity |\n|---|---|\n";
  for (const Stage stage : kStages) {
    out += fmt::format("| `{}` | {} |\n", validate::name(stage), severity_text(rule, stage));
  }
  if (!examples.fail.empty()) {
    out += fmt::format(
        "\n| Breaks the rule | Keeps it |\n|---|---|\n| ![A model that breaks {0}, the fault marked]({1}) "
        "| ![The nearest model that keeps {0}]({2}) |\n",
        rule.id, examples.fail, examples.pass);
  }
  for (const auto& [heading, body] : sections_of(rule)) {
    out += fmt::format("\n## {}\n\n{}\n", heading, body);
    if (heading == "Fix") out += fmt::format("\nRepair: {}.\n", repair_text(rule));
  }
  if (!rule.parameters.empty())
    out += fmt::format("\n## Configuration\n\nIn `radlint.toml`, `[rules.{}]`:\n\n", rule.id);
  for (const validate::Parameter& parameter : rule.parameters) {
    out += fmt::format("- `{}`{}\n", parameter.name, parameter_text(parameter).substr(parameter.name.size()));
  }
  out += "\n## Examples\n\n" + examples_text(rule) + '\n';
  return out;
}

std::string rule_json(const Rule& rule) { return written(json_of(rule)); }

std::string rules_text(std::span<const Rule* const> rules, std::size_t width) {
  constexpr std::size_t kLead = 28;
  std::string out = "rule   requirement  at model\n";
  for (const Rule* rule : rules) {
    std::string body;
    append_wrapped(body, fmt::format("{}: {}", rule->alias, rule->title), kLead, width);
    const std::string lead = fmt::format("{}  {}{}", rule->id, padded(validate::code(rule->requirement), 13),
                                         severity_text(*rule, Stage::Model));
    out += padded(lead, kLead) + body.substr(kLead);
  }
  return out;
}

std::string rules_markdown(std::span<const Rule* const> rules) {
  std::string out =
      "# Rules\n\nEvery rule of `radlint`, lower levels first. `radlint rule RL201` prints the same page.\n\n";
  out += "| Rule | Alias | Requirement | model | preprocess | solve | display | What it reports |\n";
  out += "|---|---|---|---|---|---|---|---|\n";
  for (const Rule* rule : rules) {
    out += fmt::format("| [{0}]({0}.md) | `{1}` | {2} |", rule->id, rule->alias, validate::code(rule->requirement));
    for (const Stage stage : kStages) out += fmt::format(" {} |", severity_text(*rule, stage));
    out += fmt::format(" {} |\n", rule->title);
  }
  return out;
}

std::string rules_json(std::span<const Rule* const> rules) {
  Json json = Json::array();
  for (const Rule* rule : rules) json.push_back(json_of(*rule));
  return written(json);
}

}  // namespace rad::report
