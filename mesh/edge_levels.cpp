#include "mesh/edge_levels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/lengths.h"

namespace rad::mesh {
namespace {

struct EdgeEnd {
  std::uint32_t point = 0;
  std::uint32_t* levels = nullptr;
  double length = 0;  ///< of the edge, pitches
  geom::dvec3 direction{0, 0, 0};
};

// How often an edge can be halved before its first point is nearer to the end than `reach`.
std::uint32_t levels_beyond(double length, double reach) {
  std::uint32_t levels = 0;
  for (double left = length; left >= 2 * reach; left /= 2) ++levels;
  return levels;
}

void limit(const EdgeEnd& end, double reach) {
  if (reach > 0) *end.levels = std::min(*end.levels, levels_beyond(end.length, reach));
}

}  // namespace

void EdgeLevels::allow(std::uint32_t a, std::uint32_t b, std::uint32_t levels) {
  std::uint32_t& least = levels_.try_emplace(key(a, b), levels).first->second;
  least = std::min(least, levels);
}

void EdgeLevels::keep_apart(std::span<const geom::LatticePoint> points, double spacing) {
  std::vector<EdgeEnd> ends;
  for (auto& [edge, levels] : levels_) {
    const geom::dvec3 along = geom::as_vector(points[edge[1]]) - geom::as_vector(points[edge[0]]);
    const double length = glm::length(along);
    ends.push_back({edge[0], &levels, length, along / length});
    ends.push_back({edge[1], &levels, length, -along / length});
  }
  std::ranges::stable_sort(ends, {}, &EdgeEnd::point);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size() && ends[j].point == ends[i].point; ++j) {
      const double reach = reach_apart(ends[i].direction, ends[j].direction, spacing);
      limit(ends[i], reach);
      limit(ends[j], reach);
    }
  }
}

}  // namespace rad::mesh
