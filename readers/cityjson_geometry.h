// Boundaries of CityJSON geometries, and what is said of their surfaces.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "readers/json_view.h"

namespace rad::readers::cityjson {

/// How many arrays lie around the surfaces of a geometry of this type: 1 for MultiSurface, 2 for Solid, 3 for
/// MultiSolid. Nothing for types without surfaces.
std::optional<int> levels_above_surfaces(std::string_view type);

/// Values that go with surfaces, in arrays nested as the boundaries are; null may stand for all below it.
class SurfaceValues {
 public:
  SurfaceValues() = default;
  explicit SurfaceValues(const Json* values) : values_(values) {}

  /// The values of item `index` of the arrays.
  [[nodiscard]] SurfaceValues at(std::size_t index) const;
  [[nodiscard]] std::optional<std::uint64_t> whole() const;
  [[nodiscard]] const Json* json() const { return values_; }

 private:
  const Json* values_ = nullptr;
};

/// The level of detail of a geometry as a number, from a number or a text; -1 where it states none.
double level_of_detail(const Json& geometry);

/// Whether a level is the one chosen: 2 is 2, 2.1, 2.2…
bool is_level(double level, double chosen);

}  // namespace rad::readers::cityjson
