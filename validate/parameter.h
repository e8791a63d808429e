// Thresholds of rules that a user may set: what there is to set, and what was set.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rad::validate {

struct Rule;

/// One threshold of a rule: `[rules.RL240] min-shape = 0.15` in radlint.toml.
struct Parameter {
  std::string_view name;  ///< with hyphens: "min-shape"
  std::string_view unit;  ///< "T", "m", "degrees", "1"
  double standard = 0;    ///< where nothing is set
  double low = 0;         ///< least value that may be set
  double high = 0;        ///< largest value that may be set
  std::string_view what;  ///< one clause, lower case, no full stop
};

/// Null where the rule has no parameter of that name.
const Parameter* find_parameter(const Rule& rule, std::string_view name);

/// The parameter of the rule nearest to a mistyped name, for "did you mean"; empty where it has none.
std::string_view nearest_parameter(const Rule& rule, std::string_view name);

/// Values that differ from the standard ones.
class ParameterValues {
 public:
  /// Empty where the value was taken; else why not, in one clause: "RL240 has no parameter min-size; did you mean
  /// min-shape?", "min-shape of RL240 lies between 0 and 1".
  std::string set(const Rule& rule, std::string_view name, double value);

  /// What is set, else the standard value. The rule must have the parameter.
  [[nodiscard]] double of(const Rule& rule, std::string_view name) const;

  friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

 private:
  std::map<std::pair<std::string_view, std::string_view>, double> values_;  ///< by rule id and parameter name
};

}  // namespace rad::validate
