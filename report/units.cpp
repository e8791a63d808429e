#include "report/units.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace rad::report {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 5> kUnits = {
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};

}  // namespace

std::optional<double> metres_in(std::string_view unit) {
  for (const auto& [name, metres] : kUnits) {
    if (name == unit) return metres;
  }
  return std::nullopt;
}

std::string unit_name(double metres_per_unit) {
  for (const auto& [name, metres] : kUnits) {
    if (metres == metres_per_unit) return std::string(name);
  }
  return fmt::format("{:.6g} m", metres_per_unit);
}

std::string unit_label(std::optional<double> metres_per_unit) {
  if (!metres_per_unit) return "units";
  const std::string name = unit_name(*metres_per_unit);
  return metres_in(name) ? name : fmt::format("units of {}", name);
}

}  // namespace rad::report
