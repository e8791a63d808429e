#include "bake/border_balance.h"

#include <glm/geometric.hpp>

namespace rad::bake {

void BorderBalance::add_edge(const dvec2& from, const dvec2& to, const dvec3& value_from, const dvec3& value_to) {
  constexpr double kSpacing = 0.5;
  const double pieces = std::max(1.0, std::ceil(glm::distance(from, to) / kSpacing));
  const auto last_column = static_cast<double>(columns_ - 2), last_row = static_cast<double>(rows_ - 2);
  for (double piece = 0; piece <= pieces; ++piece) {
    const double share = piece / pieces;
    const dvec2 at = from + (to - from) * share;
    const double column = std::clamp(std::floor(at.x), 0.0, last_column);
    const double row = std::clamp(std::floor(at.y), 0.0, last_row);
    samples_.push_back({static_cast<std::uint32_t>(column),
                        static_cast<std::uint32_t>(row),
                        {at.x - column, at.y - row},
                        value_from + (value_to - value_from) * share});
  }
}

}  // namespace rad::bake
