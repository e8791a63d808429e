#include "config/settings_keys.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "config/words.h"
#include "report/units.h"
#include "validate/parameter.h"
#include "validate/registry.h"

namespace rad::config {

namespace {

template <typename Value>
Value chosen(const Entry& entry, Choices<Value> choices) {
  Value value{};
  if (const std::string fault = choose<Value>(entry.text(), choices, value); !fault.empty()) entry.fail(fault);
  return value;
}

const validate::Rule& rule_named(const Entry& entry) {
  if (const validate::Rule* rule = validate::find_rule(entry.member.key)) return *rule;
  throw ConfigFault(entry.file, entry.member.line, unknown_rule_text(entry.member.key));
}

double positive(const Entry& entry) {
  const double value = entry.number();
  if (!std::isfinite(value) || value <= 0) entry.fail("a number above 0 is expected");
  return value;
}

void read_units(const Entry& entry, Settings& into) {
  const auto metres = report::metres_in(entry.text());
  if (!metres) entry.fail("'" + entry.text() + "' is none of m, cm, mm, in, ft");
  into.metres_per_unit = {*metres, entry.origin()};
}

void read_tolerance(const Entry& entry, Settings& into) {
  if (entry.member.value.kind == Value::Kind::Number) {
    into.tolerance = {{positive(entry), geom::ToleranceRequest::Measure::FileUnits}, entry.origin()};
    return;
  }
  const auto request = geom::parse_tolerance(entry.text());
  if (!request) {
    entry.fail("'" + entry.text() +
               "' is not a length; write \"0.5mm\", 0.5 (file units), \"1e-5d\" (box diagonals) or "
               "\"auto\"");
  }
  into.tolerance = {*request, entry.origin()};
}

void read_parameter(const Entry& entry, const validate::Rule& rule, RuleSettings& into) {
  const validate::Parameter* parameter = validate::find_parameter(rule, entry.member.key);
  if (parameter == nullptr) {
    std::vector<std::string_view> names{"severity"};
    for (const validate::Parameter& known : rule.parameters) names.push_back(known.name);
    throw ConfigFault(entry.file, entry.member.line,
                      fmt::format("unknown key '{}' of {} {}{}", entry.member.key, rule.id, rule.alias,
                                  did_you_mean(nearest(entry.member.key, names))));
  }
  validate::ParameterValues probe;
  if (const std::string fault = probe.set(rule, parameter->name, entry.number()); !fault.empty()) entry.fail(fault);
  into.parameters[parameter->name] = {entry.number(), entry.origin()};
}

void read_rule(const Entry& table, const validate::Rule& rule, RuleSettings& into) {
  for (const Member& inner : table.table().members) {
    const Entry value{inner, table.file};
    if (inner.key == "severity") {
      into.severity = {chosen<RuleSeverity>(value, kSeverities), value.origin()};
    } else {
      read_parameter(value, rule, into);
    }
  }
}

void read_rules(const Entry& entry, Settings& into) {
  for (const Member& member : entry.table().members) {
    const Entry table{member, entry.file};
    const validate::Rule& rule = rule_named(table);
    read_rule(table, rule, into.rules[&rule]);
  }
}

constexpr std::array<Key<Settings>, 9> kKeys = {{
    {{"select", "check these rules only: ids, beginnings of ids, names, ALL"},
     [](const Entry& entry, Settings& into) {
       into.select = {selectors_of(entry), entry.origin()};
     }},
    {{"ignore", "leave these rules out, in place of those that were left out before"},
     [](const Entry& entry, Settings& into) {
       into.ignore = {selectors_of(entry), entry.origin()};
     }},
    {{"extend-select", "check these rules too"},
     [](const Entry& entry, Settings& into) {
       into.extend_select = {selectors_of(entry), entry.origin()};
     }},
    {{"extend-ignore", "leave these rules out too"},
     [](const Entry& entry, Settings& into) {
       into.extend_ignore = {selectors_of(entry), entry.origin()};
     }},
    {{"units", "unit of the files: m, cm, mm, in, ft"}, &read_units},
    {{"up", "up axis of the files: y, z"},
     [](const Entry& entry, Settings& into) {
       into.up = {chosen<scene::UpAxis>(entry, kUpAxes), entry.origin()};
     }},
    {{"tolerance", "lengths up to this one are noise: \"0.5mm\", 0.5 (file units), \"1e-5d\" (diagonals), \"auto\""},
     &read_tolerance},
    {{"lod", "CityJSON: level of detail, as 2 or 2.2"},
     [](const Entry& entry, Settings& into) {
       into.level_of_detail = {positive(entry), entry.origin()};
     }},
    {{"rules", "severity and thresholds, in a table for each rule"}, &read_rules},
}};

}  // namespace

std::span<const Key<Settings>> settings_keys() { return kKeys; }

Words selectors_of(const Entry& entry) {
  Words selectors = entry.texts();
  for (const std::string& selector : selectors) {
    if (validate::matching_rules(selector).empty()) entry.fail(unknown_rule_text(selector));
  }
  return selectors;
}

std::map<const validate::Rule*, RuleSettings> rules_in(const Entry& entry) {
  std::map<const validate::Rule*, RuleSettings> rules;
  for (const Member& member : entry.table().members) {
    const Entry it{member, entry.file};
    const validate::Rule& rule = rule_named(it);
    RuleSettings& settings = rules[&rule];
    if (member.value.kind == Value::Kind::Table) {
      read_rule(it, rule, settings);
    } else {
      settings.severity = {chosen<RuleSeverity>(it, kSeverities), it.origin()};
    }
  }
  return rules;
}

}  // namespace rad::config
