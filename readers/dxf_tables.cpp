#include "readers/dxf_tables.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rad::readers::dxf {
namespace {

constexpr double kInch = 0.0254;
constexpr double kFoot = 12 * kInch;
constexpr double kSurveyFoot = 1200.0 / 3937;

// $INSUNITS by number.
constexpr std::array<double, 25> kUnits = {0,
                                           kInch,
                                           kFoot,
                                           5280 * kFoot,
                                           0.001,
                                           0.01,
                                           1,
                                           1000,
                                           1e-6 * kInch,
                                           1e-3 * kInch,
                                           3 * kFoot,
                                           1e-10,
                                           1e-9,
                                           1e-6,
                                           0.1,
                                           10,
                                           100,
                                           1e9,
                                           1.495978707e11,
                                           9.4607304725808e15,
                                           3.0856775814913673e16,
                                           kSurveyFoot,
                                           kSurveyFoot / 12,
                                           3 * kSurveyFoot,
                                           5280 * kSurveyFoot};

constexpr std::int64_t kFrozen = 1;
constexpr std::int64_t kByLayerLimit = 256;

}  // namespace

std::optional<double> metres_of_insertion_unit(std::int64_t code) {
  if (code < 1 || code >= static_cast<std::int64_t>(kUnits.size())) return std::nullopt;
  return kUnits[static_cast<std::size_t>(code)];
}

std::string folded(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

void Layers::add(const Entity& record) {
  Layer layer;
  layer.name = std::string(record.text(2));
  const std::int64_t colour = record.integer(62, 7);
  layer.colour = static_cast<int>(
      std::min<std::int64_t>(std::llabs(std::max<std::int64_t>(colour, -kByLayerLimit)), kByLayerLimit));
  layer.visible = colour >= 0 && (record.integer(70) & kFrozen) == 0;
  if (record.find(420) != nullptr) layer.true_colour = static_cast<std::uint32_t>(record.integer(420)) & 0xFFFFFF;
  layers_.insert_or_assign(folded(layer.name), std::move(layer));
}

const Layer& Layers::find(std::string_view name) {
  const auto [entry, fresh] = layers_.try_emplace(folded(name));
  if (fresh) entry->second.name = std::string(name);
  return entry->second;
}

std::optional<double> read_header_unit(Groups& groups) {
  std::optional<double> metres;
  bool is_unit = false;
  while (groups.next() && !groups.group().starts("ENDSEC")) {
    const Group& group = groups.group();
    if (group.code == 9) is_unit = group.value == "$INSUNITS";
    if (group.code != 70 || !is_unit) continue;
    metres = metres_of_insertion_unit(parse_integer(group.value).value_or(0));
  }
  return metres;
}

void read_layers(Groups& groups, Layers& layers, scene::ReadIssues& issues) {
  while (groups.next() && !groups.group().starts("ENDSEC")) {
    if (groups.group().starts("LAYER")) layers.add(Entity(groups, issues));
  }
}

}  // namespace rad::readers::dxf
