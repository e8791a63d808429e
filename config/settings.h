// What one place says about how models are judged: the top of a file, a [[files]] entry, or the command line.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/stated.h"
#include "geom/tolerance.h"
#include "scene/finding.h"
#include "scene/scene.h"
#include "validate/rule.h"

namespace rad::config {

using Words = std::vector<std::string>;

/// Nothing in place of a severity: the rule is off.
using RuleSeverity = std::optional<scene::Severity>;

struct RuleSettings {
  std::optional<Stated<RuleSeverity>> severity;
  std::map<std::string_view, Stated<double>> parameters;  ///< by the name in Rule::parameters
};

/// Every member is empty where nothing is said about it.
struct Settings {
  std::optional<Stated<Words>> select, ignore, extend_select, extend_ignore;  ///< ids, aliases, prefixes, ALL
  std::optional<Stated<double>> metres_per_unit;
  std::optional<Stated<scene::UpAxis>> up;
  std::optional<Stated<geom::ToleranceRequest>> tolerance;
  std::optional<Stated<double>> level_of_detail;
  std::map<const validate::Rule*, RuleSettings> rules;
};

}  // namespace rad::config
