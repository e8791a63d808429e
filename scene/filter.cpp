#include "scene/filter.h"

#include <algorithm>

namespace rad::scene {
namespace {

constexpr std::array<std::string_view, kFilters.size()> kNames{"grouper", "isect", "coplanar", "orient",
                                                               "pmesh",   "emesh", "solve",    "bake"};

}  // namespace

std::string_view name(Filter filter) { return kNames[static_cast<std::size_t>(filter)]; }

std::optional<Filter> parse_filter(std::string_view text) {
  const auto* const found = std::ranges::find(kNames, text);
  if (found == kNames.end()) return std::nullopt;
  return kFilters[static_cast<std::size_t>(found - kNames.begin())];
}

std::string names(const FilterSet& filters) {
  std::string text;
  for (const Filter filter : kFilters) {
    if (!filters.has(filter)) continue;
    if (!text.empty()) text += ", ";
    text += name(filter);
  }
  return text;
}

}  // namespace rad::scene
