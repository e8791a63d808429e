#include "validate/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "validate/edit_distance.h"
#include "validate/rule.h"

namespace rad::validate {

const Parameter* find_parameter(const Rule& rule, std::string_view name) {
  const auto found = std::ranges::find(rule.parameters, name, &Parameter::name);
  return found == rule.parameters.end() ? nullptr : &*found;
}

std::string_view nearest_parameter(const Rule& rule, std::string_view name) {
  const auto distance = [&](const Parameter& parameter) { return edit_distance(name, parameter.name); };
  const auto nearest = std::ranges::min_element(rule.parameters, {}, distance);
  return nearest == rule.parameters.end() ? std::string_view() : nearest->name;
}

std::string ParameterValues::set(const Rule& rule, std::string_view name, double value) {
  const Parameter* parameter = find_parameter(rule, name);
  if (!parameter) {
    const std::string_view nearest = nearest_parameter(rule, name);
    if (nearest.empty()) return fmt::format("{} has no parameters", rule.id);
    return fmt::format("{} has no parameter {}; did you mean {}?", rule.id, name, nearest);
  }
  if (!(value >= parameter->low && value <= parameter->high)) {
    return fmt::format("{} of {} lies between {} and {}", name, rule.id, parameter->low, parameter->high);
  }
  values_[{rule.id, parameter->name}] = value;
  return {};
}

double ParameterValues::of(const Rule& rule, std::string_view name) const {
  const auto set = values_.find({rule.id, name});
  if (set != values_.end()) return set->second;
  const Parameter* parameter = find_parameter(rule, name);
  if (!parameter) throw std::logic_error(fmt::format("{} has no parameter {}", rule.id, name));
  return parameter->standard;
}

}  // namespace rad::validate
