// Pieces of JSON reports, read back. Only .cpp files of this folder include it.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "report/json_parts.h"
#include "report/report.h"

namespace rad::report {

/// A report that is JSON but not one of ours, or of another version; what() says which value is wrong.
struct UnknownShape : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value of `names` that name() turns into the text. Throws UnknownShape for other texts.
template <typename Value, typename... Values>
Value named(const Json& json, Value first, Values... others) {
  const auto& text = json.get_ref<const std::string&>();
  for (const Value value : {first, others...}) {
    if (name(value) == text) return value;
  }
  throw UnknownShape("'" + text + "' is not known to this version");
}

/// The rule of this id. Throws UnknownShape where this version has none.
const validate::Rule& rule_of(const Json& json);

/// A number, NaN for null.
double read_number(const Json& json);
geom::dvec3 read_point(const Json& json);
scene::Severity read_severity(const Json& json);

/// What input_json() wrote, without findings. Throws UnknownShape and Json::exception.
InputReport read_input(const Json& json);

/// What finding_json() wrote.
scene::Finding read_finding(const Json& json);

}  // namespace rad::report
