#include "readers/cityjson_geometry.h"

#include <cmath>

#include "readers/text_cursor.h"

namespace rad::readers::cityjson {

std::optional<int> levels_above_surfaces(std::string_view type) {
  if (type == "MultiSurface" || type == "CompositeSurface") return 1;
  if (type == "Solid") return 2;
  if (type == "MultiSolid" || type == "CompositeSolid") return 3;
  return std::nullopt;
}

SurfaceValues SurfaceValues::at(std::size_t index) const {
  if (values_ == nullptr || !values_->is_array() || index >= values_->size()) return {};
  return SurfaceValues(&(*values_)[index]);
}

std::optional<std::uint64_t> SurfaceValues::whole() const {
  if (values_ == nullptr || !values_->is_number_unsigned()) return std::nullopt;
  return values_->get<std::uint64_t>();
}

double level_of_detail(const Json& geometry) {
  const auto found = geometry.find("lod");
  if (found == geometry.end()) return -1;
  if (found->is_number()) return found->get<double>();
  if (found->is_string()) return parse_number(found->get_ref<const std::string&>()).value_or(-1);
  return -1;
}

bool is_level(double level, double chosen) {
  return level == chosen || (chosen == std::floor(chosen) && std::floor(level) == chosen);
}

}  // namespace rad::readers::cityjson
