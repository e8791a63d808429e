// The words that stand for values, in files of configuration and on the command line.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "config/nearest.h"
#include "config/settings.h"
#include "report/report.h"
#include "validate/stage.h"

namespace rad::config {

template <typename Value>
using Choices = std::span<const std::pair<std::string_view, Value>>;

inline constexpr std::array<std::pair<std::string_view, validate::Stage>, 4> kStages = {
    {{"model", validate::Stage::Model},
     {"preprocess", validate::Stage::Preprocess},
     {"solve", validate::Stage::Solve},
     {"display", validate::Stage::Display}}};
inline constexpr std::array<std::pair<std::string_view, report::FailOn>, 4> kFailOn = {
    {{"error", report::FailOn::Error},
     {"warning", report::FailOn::Warning},
     {"note", report::FailOn::Note},
     {"never", report::FailOn::Never}}};
inline constexpr std::array<std::pair<std::string_view, scene::UpAxis>, 2> kUpAxes = {
    {{"y", scene::UpAxis::Y}, {"z", scene::UpAxis::Z}}};
inline constexpr std::array<std::pair<std::string_view, RuleSeverity>, 4> kSeverities = {
    {{"error", scene::Severity::Error},
     {"warning", scene::Severity::Warning},
     {"note", scene::Severity::Note},
     {"off", std::nullopt}}};

/// The value of a word. What is wrong with the word where it stands for none: "'mild' is none of error, warning, note".
template <typename Value>
std::string choose(std::string_view word, Choices<Value> choices, Value& into) {
  std::vector<std::string_view> names;
  std::string listed;
  for (const auto& [name, value] : choices) {
    if (name == word) {
      into = value;
      return {};
    }
    names.push_back(name);
    listed += (listed.empty() ? "" : ", ") + std::string(name);
  }
  return "'" + std::string(word) + "' is none of " + listed + did_you_mean(nearest(word, names));
}

/// "no rule is called 'RL2o1'; did you mean RL201? (radlint rules lists all)"
std::string unknown_rule_text(std::string_view selector);

}  // namespace rad::config
