#include "validate/stage.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rad::validate {
namespace {

using scene::Severity;

constexpr std::optional<Severity> kError = Severity::Error;
constexpr std::optional<Severity> kWarning = Severity::Warning;
constexpr std::optional<Severity> kNote = Severity::Note;
constexpr std::optional<Severity> kOff = std::nullopt;

// Columns: model (Table 2 after Coplanar), then Table 1's preprocess, solve, display. Required is an error, desired a
// warning, generated a note; passed through and blank are off.
constexpr std::array<std::array<std::optional<Severity>, 4>, 11> kTable{{
    {kWarning, kOff, kError, kOff},      // 1a solid model, valid facades
    {kError, kError, kError, kOff},      // 1b normal consistency
    {kWarning, kNote, kOff, kOff},       // 1c maximally connected planar faces (Table 2 only)
    {kError, kNote, kError, kError},     // 2a no T-vertices
    {kError, kNote, kError, kOff},       // 2b no implicit intersections
    {kError, kNote, kError, kError},     // 2c no overlapping coplanar faces
    {kNote, kNote, kError, kOff},        // 2d simple mesh faces
    {kNote, kNote, kWarning, kWarning},  // 2e well-shaped faces
    {kNote, kNote, kError, kOff},        // 2f sufficient radiator density
    {kNote, kNote, kError, kOff},        // 2g sufficient receiver density
    {kNote, kNote, kNote, kError},       // 3a ziplocking; at solve passed through, shown as a note
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kRequirements{{
    {"1a", "solid model, valid facades"},
    {"1b", "normal consistency"},
    {"1c", "maximal planar faces"},
    {"2a", "no T-vertices"},
    {"2b", "no implicit intersections"},
    {"2c", "no overlapping coplanar faces"},
    {"2d", "simple mesh faces"},
    {"2e", "well-shaped faces"},
    {"2f", "sufficient radiator density"},
    {"2g", "sufficient receiver density"},
    {"3a", "ziplocking"},
    {"input", "readable input"},
    {"materials", "materials and light"},
    {"units", "units and scale"},
}};

constexpr std::array<std::pair<std::string_view, Stage>, 4> kStages{{
    {"model", Stage::Model},
    {"preprocess", Stage::Preprocess},
    {"solve", Stage::Solve},
    {"display", Stage::Display},
}};

}  // namespace

std::string_view code(Requirement requirement) { return kRequirements[static_cast<std::size_t>(requirement)].first; }

std::string_view title(Requirement requirement) { return kRequirements[static_cast<std::size_t>(requirement)].second; }

std::optional<Stage> parse_stage(std::string_view text) {
  for (const auto& [stage_name, stage] : kStages) {
    if (text == stage_name) return stage;
  }
  return std::nullopt;
}

std::string_view name(Stage stage) { return kStages[static_cast<std::size_t>(stage)].first; }

std::optional<Severity> severity_at(const Rule& rule, Stage stage) {
  const auto row = static_cast<std::size_t>(rule.requirement);
  if (row >= kTable.size()) return rule.severity;
  const std::optional<Severity> asked = kTable[row][static_cast<std::size_t>(stage)];
  if (!asked) return std::nullopt;
  return std::min(*asked, rule.severity);
}

std::optional<Severity> grave_severity_at(const Rule& rule, Stage stage) {
  const auto severity = severity_at(rule, stage);
  return severity && stage == Stage::Solve && rule.grave_at_solve ? rule.grave_at_solve : severity;
}

}  // namespace rad::validate
