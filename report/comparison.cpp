#include "report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "report/text_layout.h"
#include "validate/registry.h"

namespace rad::report {

namespace {

using scene::Finding;
using Findings = std::vector<const Finding*>;

bool holds_triangles_only(const InputReport& input) {
  return input.format == "glb" || input.format == "gltf" || input.format == "stl";
}

/// Whether a rule judges how a file says things, or faces as a format cuts them up, more than what the model is.
bool judges_format(std::string_view id) {
  const validate::Rule* rule = validate::find_rule(id);
  if (rule == nullptr) return false;
  switch (rule->requirement) {
    case validate::Requirement::MaximalPlanarFaces:
    case validate::Requirement::SimpleFaces:
    case validate::Requirement::WellShapedFaces:
    case validate::Requirement::Materials:
    case validate::Requirement::Input:
    case validate::Requirement::Units:
      return true;
    default:
      return false;
  }
}

/// Whether files of a format have names for objects and materials.
bool knows_names(const InputReport& input) {
  return input.format != "ply" && input.format != "stl" && input.format != "off";
}

/// Whether a rule judges faces by the object that they belong to.
bool judges_names(std::string_view id) {
  const validate::Rule* rule = validate::find_rule(id);
  return rule != nullptr && rule->requirement == validate::Requirement::SolidModel;
}

double extent_of(const Finding& finding) {
  return finding.where.bounds ? glm::distance((*finding.where.bounds)[0], (*finding.where.bounds)[1]) : 0;
}

std::uint64_t violations_in(const Findings& findings) {
  std::uint64_t sum = 0;
  for (const Finding* finding : findings) sum += finding->count;
  return sum;
}

scene::Severity highest(const Findings& findings) {
  return (*std::ranges::max_element(findings, {}, [](const Finding* finding) { return finding->severity; }))->severity;
}

/// What a movement of vertices within T makes of a measure.
double noise_of(const scene::Measure& measure, const Finding& finding, double tolerance) {
  if (measure.unit.ends_with("²")) return tolerance * std::max(extent_of(finding), std::sqrt(std::abs(measure.value)));
  if (measure.unit.ends_with("³")) return tolerance * std::pow(std::max(extent_of(finding), tolerance), 2);
  return measure.unit == "1" ? 1e-3 : tolerance;
}

bool measure_changed(const Finding& old, const Finding& now, double tolerance) {
  constexpr double kShare = 0.1;
  if (!old.measure || !now.measure) return false;
  const double apart = std::abs(old.measure->value - now.measure->value);
  const double larger = std::max(std::abs(old.measure->value), std::abs(now.measure->value));
  return apart > kShare * larger && apart > noise_of(*now.measure, now, tolerance);
}

}  // namespace

Comparison::Comparison(const InputReport& old, const InputReport& now)
    : old_(old),
      now_(now),
      same_kind_(holds_triangles_only(old) == holds_triangles_only(now)),
      names_lost_(knows_names(old) != knows_names(now)) {
  for (const InputReport* input : {&old, &now}) {
    if (input->result.tolerance) tolerance_ = std::max(tolerance_, input->result.tolerance->length);
  }
}

Matching Comparison::matching() const {
  return match_findings(old_.result.findings, now_.result.findings,
                        {.tolerance = tolerance_, .names_lost = names_lost_, .regrouped = !same_kind_});
}

bool Comparison::is_of_format(const Finding& finding) const {
  return (old_.format != now_.format && judges_format(finding.rule)) || (names_lost_ && judges_names(finding.rule));
}

// Numbers of faces, pairs of them and shares of their areas depend on how a format cuts faces up.
FaultChange Comparison::change_of(const Match& match) const {
  const Finding& old = *match.old.front();
  const Finding& now = *match.now.front();
  const scene::Severity was = highest(match.old);
  const scene::Severity is = highest(match.now);
  const std::uint64_t before = violations_in(match.old);
  const std::uint64_t after = violations_in(match.now);
  if (was != is && old.rule == now.rule && !is_of_format(now)) {
    return {fmt::format("{} before, {} now", scene::name(was), scene::name(is)), is > was};
  }
  if (!same_kind_ || names_lost_ || is_of_format(now)) return {};
  if (before != after) return {fmt::format("{} before, {} now", counted(before, "place"), after), after > before};
  if (!measure_changed(old, now, tolerance_)) return {};
  return {fmt::format("{} {} before, {} now", now.measure->name, short_number(old.measure->value),
                      short_number(now.measure->value)),
          false};
}

}  // namespace rad::report
