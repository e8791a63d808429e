#include "report/json_parts.h"

#include <algorithm>
#include <cmath>

#include "report/requirements.h"
#include "report/units.h"

namespace rad::report {

namespace {

Json units_json(const InputReport& input) {
  Json json;
  json["value"] = input.metres_per_unit ? Json(unit_name(*input.metres_per_unit)) : Json(nullptr);
  json["metresPerUnit"] = input.metres_per_unit ? number(*input.metres_per_unit) : Json(nullptr);
  json["source"] = name(input.units_source);
  return json;
}

Json up_json(const InputReport& input) {
  Json json;
  json["value"] = input.up == scene::UpAxis::Unknown ? Json(nullptr) : Json(name(input.up));
  json["source"] = name(input.up_source);
  return json;
}

Json lattice_json(const InputReport& input) {
  if (!input.result.tolerance) return nullptr;
  Json json;
  json["pitch"] = number(input.result.pitch);
  json["origin"] = point_json(input.result.lattice_origin);
  return json;
}

Json bounds_json(const geom::Box& box) {
  if (box.empty()) return nullptr;
  return Json::array({point_json(box.low), point_json(box.high)});
}

Json figures_json(const InputReport& input) {
  const validate::ModelFigures& figures = input.result.figures;
  Json json;
  json["vertices"] = figures.vertices;
  json["faces"] = figures.faces;
  json["triangles"] = figures.triangles;
  json["objects"] = figures.objects;
  json["materials"] = figures.materials;
  json["emitters"] = figures.emitters;
  json["bounds"] = bounds_json(input.box);
  return json;
}

Json auto_json(const geom::AutoChoice& choice) {
  const bool found = choice.confidence > 0;
  Json json;
  json["low"] = found ? number(choice.low) : Json(nullptr);
  json["high"] = found ? number(choice.high) : Json(nullptr);
  json["default"] = number(choice.usual);
  json["joinedBeyondDefault"] = choice.joined;
  return json;
}

Json counts_json(const Counts& counts) {
  Json json;
  json["errors"] = counts.errors;
  json["warnings"] = counts.warnings;
  json["notes"] = counts.notes;
  return json;
}

Json by_rule_json(const Report& report) {
  Json json = Json::object();
  for (const RuleTotal& total : rule_totals(report)) {
    Json& rule = json[std::string(total.rule)];
    rule["count"] = total.places;
    rule["findings"] = total.findings;
    rule["severity"] = scene::name(total.severity);
    rule["truncated"] = total.truncated;
  }
  return json;
}

Json requirements_json(const Report& report) {
  Json json = Json::object();
  for (const RequirementSummary& summary : requirement_summaries(report.inputs, report.stage)) {
    Json entry;
    entry["title"] = validate::title(summary.requirement);
    entry["status"] = name(summary.status);
    entry.update(counts_json(summary.counts));
    json[std::string(validate::code(summary.requirement))] = std::move(entry);
  }
  return json;
}

Json unchecked_json(const InputReport& input, const std::vector<const validate::Rule*>& checked) {
  Json json = Json::array();
  for (const validate::Rule* rule : checked) {
    if (std::ranges::find(input.result.checked, rule) == input.result.checked.end()) json.push_back(rule->id);
  }
  return json;
}

Json unlisted_json(const InputReport& input, std::size_t max_issues) {
  Json json = Json::array();
  for (const Unlisted& rest : unlisted_findings(input, max_issues)) {
    Json entry;
    entry["rule"] = rest.rule;
    entry["severity"] = scene::name(rest.severity);
    entry["places"] = rest.places;
    entry["findings"] = rest.findings;
    json.push_back(std::move(entry));
  }
  return json;
}

Json suppressions_json(const InputReport& input) {
  Json json = Json::array();
  for (const validate::SuppressionUse& use : input.result.suppressions) {
    Json entry;
    entry["origin"] = scene::name(use.origin);
    entry["rules"] = use.rules;
    entry["reason"] = use.reason.empty() ? Json(nullptr) : Json(use.reason);
    entry["file"] = use.place.file;
    entry["line"] = use.place.line > 0 ? Json(use.place.line) : Json(nullptr);
    entry["pointer"] = use.place.pointer.empty() ? Json(nullptr) : Json(use.place.pointer);
    entry["findings"] = use.findings;
    entry["places"] = use.places;
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace

Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value == 0 ? 0.0 : value;
}

Json point_json(const geom::dvec3& point) { return Json::array({number(point.x), number(point.y), number(point.z)}); }

Json input_json(const InputReport& input) {
  Json json;
  json["path"] = input.path;
  json["configuration"] = input.configuration.empty() ? Json(nullptr) : Json(input.configuration);
  json["format"] = input.format.empty() ? Json(nullptr) : Json(input.format);
  json["bytes"] = input.bytes;
  json["read"] = input.read;
  json["units"] = units_json(input);
  json["up"] = up_json(input);
  json["lattice"] = lattice_json(input);
  json["tolerance"] = tolerance_json(input);
  json["incomplete"] = input.result.incomplete.empty() ? Json(nullptr) : Json(input.result.incomplete);
  json["figures"] = figures_json(input);
  json["summary"] = counts_json(counts(input));
  json["suppressions"] = suppressions_json(input);
  return json;
}

Json tool_json(std::string_view tool) {
  Json json;
  json["name"] = tool;
  json["version"] = tool_version();
  return json;
}

Json tolerance_json(const InputReport& input) {
  if (!input.result.tolerance) return nullptr;
  Json json;
  json["T"] = number(input.result.tolerance->length);
  json["source"] = geom::name(input.result.tolerance->source);
  json["diagonal"] = number(input.result.tolerance->diagonal);
  if (const auto& choice = input.result.tolerance->choice) {
    json["confidence"] = number(choice->confidence);
    json["auto"] = auto_json(*choice);
  }
  return json;
}

Json only_tolerance_json(const Report& report) {
  return report.inputs.size() == 1 ? tolerance_json(report.inputs.front()) : Json(nullptr);
}

Json inputs_json(const Report& report) {
  Json json = Json::array();
  const std::vector<const validate::Rule*> checked = checked_rules(report);
  for (const InputReport& input : report.inputs) {
    Json& entry = json.emplace_back(input_json(input));
    entry["unchecked"] = unchecked_json(input, checked);
    entry["unlisted"] = unlisted_json(input, report.max_issues);
  }
  return json;
}

Json summary_json(const Report& report) {
  Json json = counts_json(counts(report));
  json["known"] = known_findings(report);
  json["suppressed"] = suppressed_findings(report);
  json["byRule"] = by_rule_json(report);
  json["requirements"] = requirements_json(report);
  json["checkedRules"] = Json::array();
  for (const validate::Rule* rule : checked_rules(report)) json["checkedRules"].push_back(rule->id);
  return json;
}

Json timings_json(const Report& report, bool with_timings) {
  Json json = Json::object();
  if (!with_timings) return json;
  for (const InputReport& input : report.inputs) {
    for (const auto& [step, seconds] : input.result.timings) {
      json[step] = json.value(step, 0.0) + seconds;
    }
  }
  return json;
}

std::string written(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string written_on_one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rad::report
