#include "schema_checker.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace rad::report {

namespace {

using nlohmann::json;

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

bool has_some_type(const json& value, const json& types) {
  if (types.is_string()) return has_type(value, types.get<std::string>());
  return std::any_of(types.begin(), types.end(), [&](const json& type) { return has_type(value, type); });
}

/// Keywords that constrain nothing, or that check_object handles together.
bool is_silent(const std::string& keyword) {
  static const std::set<std::string> kSilent = {"$schema",    "title",         "description",          "definitions",
                                                "properties", "propertyNames", "additionalProperties", "required"};
  return kSilent.contains(keyword);
}

/// Files that "$ref"s anywhere in the schema name.
void gather_files(const json& schema, std::set<std::string>& files) {
  if (!schema.is_structured()) return;
  for (const auto& [key, member] : schema.items()) {
    if (key == "$ref") {
      const std::string reference = member.get<std::string>();
      if (const auto hash = reference.find('#'); hash > 0) files.insert(reference.substr(0, hash));
    }
    gather_files(member, files);
  }
}

}  // namespace

SchemaChecker::SchemaChecker(const std::string& file) : root_(file) { load(file); }

void SchemaChecker::load(const std::string& file) {
  if (files_.contains(file)) return;
  std::ifstream stream(std::string(RAD_SOURCE_DIR) + "/report/" + file);
  const Json& schema = files_[file] = json::parse(stream);
  std::set<std::string> named;
  gather_files(schema, named);
  for (const std::string& other : named) load(other);
}

SchemaChecker::Rules SchemaChecker::resolved(const std::string& reference, const std::string& from) const {
  const std::size_t hash = reference.find('#');
  const auto found = files_.find(hash == 0 ? from : reference.substr(0, hash));
  return {found->second.at(Json::json_pointer(reference.substr(hash + 1))), found->first};
}

std::vector<std::string> SchemaChecker::faults(const json& value) const {
  Faults faults;
  const auto root = files_.find(root_);
  check(value, {root->second, root->first}, "", faults);
  return faults;
}

void SchemaChecker::check(const Json& value, Rules rules, const std::string& at, Faults& faults) const {
  const Json& schema = rules.schema;
  if (schema.is_boolean()) {
    if (!schema.get<bool>()) faults.push_back(at + ": not allowed");
    return;
  }
  for (const auto& [keyword, rule] : schema.items()) check_keyword(keyword, {rule, rules.file}, value, at, faults);
  if (value.is_object()) check_object(value, rules, at, faults);
}

void SchemaChecker::check_keyword(const std::string& keyword, Rules rules, const Json& value, const std::string& at,
                                  Faults& faults) const {
  const Json& rule = rules.schema;
  const auto demand = [&](bool holds) {
    if (!holds) faults.push_back(at + ": breaks " + keyword + " " + rule.dump() + " with " + value.dump());
  };
  if (keyword == "$ref") {
    check(value, resolved(rule.get<std::string>(), rules.file), at, faults);
  } else if (keyword == "type") {
    demand(has_some_type(value, rule));
  } else if (keyword == "const") {
    demand(value == rule);
  } else if (keyword == "enum") {
    demand(std::find(rule.begin(), rule.end(), value) != rule.end());
  } else if (keyword == "minimum") {
    demand(!value.is_number() || value.get<double>() >= rule.get<double>());
  } else if (keyword == "minItems") {
    demand(!value.is_array() || value.size() >= rule.get<std::size_t>());
  } else if (keyword == "maxItems") {
    demand(!value.is_array() || value.size() <= rule.get<std::size_t>());
  } else if (keyword == "pattern") {
    demand(!value.is_string() || std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())));
  } else if (keyword == "items") {
    if (!value.is_array()) return;
    for (std::size_t i = 0; i < value.size(); ++i)
      check(value[i], {rule, rules.file}, at + "/" + std::to_string(i), faults);
  } else if (keyword == "anyOf") {
    demand(std::any_of(rule.begin(), rule.end(), [&](const Json& option) {
      Faults of_option;
      check(value, {option, rules.file}, at, of_option);
      return of_option.empty();
    }));
  } else if (!is_silent(keyword)) {
    faults.push_back(at + ": the checker does not know " + keyword);
  }
}

void SchemaChecker::check_object(const Json& value, Rules rules, const std::string& at, Faults& faults) const {
  const Json& schema = rules.schema;
  for (const Json& key : schema.value("required", Json::array())) {
    if (!value.contains(key.get<std::string>())) faults.push_back(at + ": lacks " + key.get<std::string>());
  }
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, member] : value.items()) {
    if (schema.contains("propertyNames"))
      check(Json(key), {schema["propertyNames"], rules.file}, at + "/" + key, faults);
    if (properties.contains(key)) {
      check(member, {properties[key], rules.file}, at + "/" + key, faults);
    } else if (schema.contains("additionalProperties")) {
      check(member, {schema["additionalProperties"], rules.file}, at + "/" + key, faults);
    }
  }
}

}  // namespace rad::report
