#include "report/sarif_rules.h"

#include <cctype>

#include "report/rule_page.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

// "TVertex" for "t-vertex": the form that SARIF asks of names.
std::string pascal_case(std::string_view alias) {
  std::string name;
  bool start = true;
  for (const char c : alias) {
    if (c == '-') {
      start = true;
    } else {
      name += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      start = false;
    }
  }
  return name;
}

// "recommendation" is what code scanning calls a note.
std::string_view problem_severity(scene::Severity severity) {
  return severity == scene::Severity::Note ? "recommendation" : scene::name(severity);
}

Json rule_json_of(const validate::Rule& rule, validate::Stage stage) {
  const auto severity = validate::severity_at(rule, stage);
  Json json;
  json["id"] = rule.id;
  json["name"] = pascal_case(rule.alias);
  json["shortDescription"]["text"] = rule.title;
  json["fullDescription"]["text"] = rule.doc.what;
  json["help"]["text"] = rule_text(rule);
  json["help"]["markdown"] = rule_markdown(rule);
  json["defaultConfiguration"]["enabled"] = severity.has_value();
  json["defaultConfiguration"]["level"] = severity ? scene::name(*severity) : std::string_view("none");
  Json& properties = json["properties"];
  properties["tags"] = Json::array({"radiosity", validate::code(rule.requirement)});
  properties["precision"] = rule.kind == scene::FindingKind::Fail ? "very-high" : "medium";
  properties["problem.severity"] = problem_severity(severity.value_or(rule.severity));
  return json;
}

}  // namespace

Json sarif_rules_json(validate::Stage stage) {
  Json json = Json::array();
  for (const validate::Rule* rule : validate::all_rules()) json.push_back(rule_json_of(*rule, stage));
  return json;
}

}  // namespace rad::report
