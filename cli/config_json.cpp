// `radlint config --format json`.
#include <nlohmann/json.hpp>

#include "cli/config_view.h"

namespace rad::cli {

namespace {

using Json = nlohmann::ordered_json;

Json setting_json(const SettingView& setting) {
  return {{"value", setting.value.empty() ? Json(nullptr) : Json(setting.value)}, {"origin", setting.origin}};
}

Json rule_json(const config::RuleInForce& it) {
  Json json;
  json["rule"] = it.rule->id;
  json["alias"] = it.rule->alias;
  json["on"] = it.on;
  json["origin"] = it.on_origin.text();
  json["severity"] = nullptr;
  if (it.severity)
    json["severity"] = {{"value", scene::name(it.severity->value)}, {"origin", it.severity->origin.text()}};
  json["parameters"] = Json::object();
  for (const validate::Parameter& parameter : it.rule->parameters) {
    const auto set = it.parameters.find(parameter.name);
    const bool given = set != it.parameters.end();
    Json& entry = json["parameters"][std::string(parameter.name)];
    entry["value"] = given ? set->second.value : parameter.standard;
    entry["unit"] = parameter.unit;
    entry["origin"] = given ? set->second.origin.text() : config::Origin{}.text();
  }
  return json;
}

Json objects_json(const config::ObjectsEntry& entry) {
  Json json;
  json["objects"] = entry.names.objects;
  json["materials"] = entry.names.materials;
  json["ignore"] = entry.ignore;
  json["rules"] = Json::object();
  for (const auto& [rule, severity] : entry.severities) json["rules"][std::string(rule->id)] = scene::name(severity);
  json["thresholds"] = Json::object();
  for (const auto& [rule, values] : entry.thresholds) {
    for (const auto& [name, value] : values) json["thresholds"][std::string(rule->id)][std::string(name)] = value;
  }
  json["reason"] = entry.reason.empty() ? Json(nullptr) : Json(entry.reason);
  json["origin"] = entry.origin.text();
  return json;
}

}  // namespace

std::string config_json(const ConfigView& view) {
  Json json;
  json["path"] = view.path;
  json["files"] = view.files;
  for (const SettingView& setting : view.settings) json["settings"][setting.name] = setting_json(setting);
  json["exclude"] = Json::array();
  for (const SettingView& pattern : view.exclude) json["exclude"].push_back(setting_json(pattern));
  json["rules"] = Json::array();
  for (const config::RuleInForce& rule : view.in_force.rules) json["rules"].push_back(rule_json(rule));
  json["objects"] = Json::array();
  for (const config::ObjectsEntry* entry : view.in_force.objects) json["objects"].push_back(objects_json(*entry));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rad::cli
