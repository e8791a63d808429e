#include "validate/message.h"

#include <fmt/format.h>

#include <algorithm>

namespace rad::validate {
namespace {

std::string_view unit_name(MeasureUnit unit) {
  switch (unit) {
    case MeasureUnit::Length:
      return "file units";
    case MeasureUnit::Area:
      return "file units²";
    case MeasureUnit::Volume:
      return "file units³";
    case MeasureUnit::Count:
      return "count";
    case MeasureUnit::Ratio:
    case MeasureUnit::None:
      return "1";
  }
  return "1";
}

std::string quantity(double value, MeasureUnit unit) {
  switch (unit) {
    case MeasureUnit::Length:
      return fmt::format("{:.6g}", value);
    case MeasureUnit::Area:
      return fmt::format("{:.6g} square units", value);
    case MeasureUnit::Volume:
      return fmt::format("{:.6g} cubic units", value);
    case MeasureUnit::Count:
      return fmt::format("{:.0f}", value);
    case MeasureUnit::Ratio:
      return fmt::format("{:.3f}", value);
    case MeasureUnit::None:
      break;
  }
  return {};
}

std::string place(const geom::dvec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

// The first three, in quotes.
std::string names_of(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) text += (i == 0 ? "\"" : ", \"") + names[i] + "\"";
  if (names.size() > kNamed) text += fmt::format(" and {} more", names.size() - kNamed);
  return text;
}

std::string participants(const scene::Finding& finding) {
  const auto& objects = finding.where.objects;
  return objects.empty() ? std::string() : " in " + names_of(objects);
}

std::string advice(double kept_below) {
  if (kept_below == 0) return "too thin for any tolerance in a model of this extent";
  return fmt::format("--tolerance {:.3g} keeps it", kept_below);
}

void replace_all(std::string& text, std::string_view placeholder, std::string_view value) {
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at + value.size())) {
    text.replace(at, placeholder.size(), value);
  }
}

// {passes|pass}: the first word for one violation, the second for more.
void choose_by_number(std::string& text, bool one) {
  for (std::size_t bar = text.find('|'); bar != std::string::npos; bar = text.find('|')) {
    const std::size_t open = text.rfind('{', bar), close = text.find('}', bar);
    if (open == std::string::npos || close == std::string::npos) return;
    const std::string word = one ? text.substr(open + 1, bar - open - 1) : text.substr(bar + 1, close - bar - 1);
    text.replace(open, close - open + 1, word);
  }
}

}  // namespace

scene::Finding finding_frame(const Rule& rule, scene::Severity severity) {
  scene::Finding finding;
  finding.rule = rule.id;
  finding.alias = rule.alias;
  finding.requirement = code(rule.requirement);
  finding.severity = severity;
  finding.kind = rule.kind;
  finding.fix = {rule.fix, rule.fix_operation};
  return finding;
}

scene::Measure measure_of(const Rule& rule, double value, std::optional<double> threshold) {
  return {rule.measure.name, value, threshold, unit_name(rule.measure.unit)};
}

std::string message_of(const Rule& rule, const scene::Finding& finding, std::string_view detail) {
  std::string text(rule.message);
  choose_by_number(text, finding.count == 1);
  replace_all(text, "{n}", std::to_string(finding.count));
  replace_all(text, "{s}", finding.count == 1 ? "" : "s");
  if (finding.measure) {
    replace_all(text, "{measure}", quantity(finding.measure->value, rule.measure.unit));
    if (finding.measure->threshold) {
      replace_all(text, "{limit}", quantity(*finding.measure->threshold, rule.measure.unit));
    }
  }
  if (finding.area) replace_all(text, "{area}", quantity(*finding.area, MeasureUnit::Area));
  if (finding.kept_below) replace_all(text, "{advice}", advice(*finding.kept_below));
  replace_all(text, "{object}", participants(finding));
  replace_all(text, "{material}", names_of(finding.where.materials));
  if (finding.where.segment) {
    const auto& [from, to] = *finding.where.segment;
    replace_all(text, "{segment}", fmt::format("from {} to {}", place(from), place(to)));
  }
  // Last, since it is the file's own words and may hold braces.
  replace_all(text, "{detail}", detail);
  return text;
}

}  // namespace rad::validate
