#include "readers/hbjson_subfaces.h"

#include <glm/geometric.hpp>

namespace rad::readers::hbjson {
namespace {

using geom::dvec3;

// The first edge of the outline that lies within the tolerance of the point.
std::optional<std::size_t> edge_at(const std::vector<OutlineCorner>& outline, const dvec3& point, double tolerance) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const dvec3& to = outline[(i + 1) % outline.size()].at;
    if (geom::distance_to_segment(point, outline[i].at, to) <= tolerance) return i;
  }
  return std::nullopt;
}

// Around the part from `first`, its corner next to the start of the edge, to the one next to the edge's end, by the way
// that leads through all others.
void go_round(std::vector<OutlineCorner>& outline, std::size_t edge, std::span<const dvec3> part, std::size_t first,
              bool backwards) {
  std::vector<OutlineCorner> way;
  for (std::size_t step = 0; step < part.size(); ++step) {
    const std::size_t corner = (backwards ? first + part.size() - step : first + step) % part.size();
    way.push_back({part[corner], corner});
  }
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(edge) + 1, way.begin(), way.end());
}

}  // namespace

Lie lie_of(std::vector<OutlineCorner>& outline, std::span<const dvec3> part, double tolerance) {
  std::vector<std::size_t> touching, edges;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto edge = edge_at(outline, part[i], tolerance);
    if (!edge) continue;
    touching.push_back(i);
    edges.push_back(*edge);
  }
  if (touching.empty()) return Lie::Inside;
  if (touching.size() != 2 || edges[0] != edges[1] || part.size() < 3) return Lie::Touching;
  const bool is_edge = touching[1] == touching[0] + 1;
  const bool is_last_edge = touching[0] == 0 && touching[1] == part.size() - 1;
  if (!is_edge && !is_last_edge) return Lie::Touching;
  const dvec3& start = outline[edges[0]].at;
  const auto from_start = [&](std::size_t corner) { return glm::length(part[corner] - start); };
  // A corner on a corner of the outline would leave an edge of no length.
  const dvec3& end = outline[(edges[0] + 1) % outline.size()].at;
  for (const std::size_t corner : touching) {
    if (from_start(corner) <= tolerance || glm::length(part[corner] - end) <= tolerance) return Lie::Touching;
  }
  const std::size_t first = from_start(touching[0]) < from_start(touching[1]) ? touching[0] : touching[1];
  const std::size_t second = first == touching[0] ? touching[1] : touching[0];
  go_round(outline, edges[0], part, first, second == (first + 1) % part.size());
  return Lie::Notch;
}

}  // namespace rad::readers::hbjson
