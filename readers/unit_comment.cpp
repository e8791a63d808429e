#include "readers/unit_comment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "readers/text_cursor.h"

namespace rad::readers {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};

constexpr std::array<Unit, 25> kUnits = {{
    {"m", 1},           {"meter", 1},          {"meters", 1},          {"metre", 1},          {"metres", 1},
    {"mm", 0.001},      {"millimeter", 0.001}, {"millimeters", 0.001}, {"millimetre", 0.001}, {"millimetres", 0.001},
    {"cm", 0.01},       {"centimeter", 0.01},  {"centimeters", 0.01},  {"centimetre", 0.01},  {"centimetres", 0.01},
    {"km", 1000},       {"kilometers", 1000},  {"kilometres", 1000},   {"in", 0.0254},        {"inch", 0.0254},
    {"inches", 0.0254}, {"ft", 0.3048},        {"foot", 0.3048},       {"feet", 0.3048},      {"yards", 0.9144},
}};

constexpr std::array<std::string_view, 6> kUnitWords = {"file units", "file unit", "model units",
                                                        "model unit", "units",     "unit"};
constexpr std::array<std::string_view, 2> kAxisWords = {"up axis", "up"};
constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The beginning of a comment without its mark, in lower case.
std::string heart_of(std::string_view comment) {
  constexpr std::size_t kLongest = 100;
  while (comment.starts_with('#')) comment.remove_prefix(1);
  std::string lower(trimmed(comment.substr(0, kLongest)));
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

// What follows the introduction and its '=' or ':'; empty where the comment is not of that form.
std::string_view declared(std::string_view comment, std::span<const std::string_view> introductions) {
  for (const std::string_view introduction : introductions) {
    if (!comment.starts_with(introduction)) continue;
    const std::string_view after = trimmed(comment.substr(introduction.size()));
    if (after.empty() || (after[0] != '=' && after[0] != ':')) return {};
    return trimmed(after.substr(1));
  }
  return {};
}

// "0.9144 m"
std::optional<double> length_in_metres(std::string_view text) {
  if (!text.ends_with(" m")) return std::nullopt;
  const auto metres = parse_number(trimmed(text.substr(0, text.size() - 2)));
  return metres && std::isfinite(*metres) && *metres > 0 ? metres : std::nullopt;
}

}  // namespace

std::optional<double> metres_of_comment(std::string_view comment) {
  const std::string heart = heart_of(comment);
  const std::string_view name = declared(heart, kUnitWords);
  const auto unit = std::ranges::find_if(kUnits, [&](const Unit& known) { return known.name == name; });
  if (unit == kUnits.end()) return length_in_metres(name);
  return unit->metres;
}

scene::UpAxis up_axis_of_comment(std::string_view comment) {
  const std::string heart = heart_of(comment);
  const std::string_view axis = declared(heart, kAxisWords);
  if (axis == "y" || axis == "+y") return scene::UpAxis::Y;
  return axis == "z" || axis == "+z" ? scene::UpAxis::Z : scene::UpAxis::Unknown;
}

}  // namespace rad::readers
