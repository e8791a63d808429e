#include "repair/soup.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::repair {

dvec3 Soup::normal_of(const SoupPiece& piece) const {
  const auto own = edges_of(piece);
  const dvec3 base = geom::as_vector(points[own.front()[0]]);
  dvec3 sum(0, 0, 0);
  for (const auto& [from, to] : own) {
    sum += glm::cross(geom::as_vector(points[from]) - base, geom::as_vector(points[to]) - base);
  }
  return sum;
}

std::array<LatticePoint, 3> Soup::triangle(const SoupPiece& piece) const {
  const auto own = edges_of(piece);
  return {points[own[0][0]], points[own[1][0]], points[own[2][0]]};
}

std::size_t replace_points(Soup& soup, std::span<const std::uint32_t> representative) {
  std::vector<std::array<PointId, 2>> edges;
  edges.reserve(soup.edges.size());
  std::vector<SoupPiece> pieces;
  pieces.reserve(soup.pieces.size());
  for (SoupPiece piece : soup.pieces) {
    const auto first = static_cast<std::uint32_t>(edges.size());
    for (const auto& [from, to] : soup.edges_of(piece)) {
      const PointId a = representative[from], b = representative[to];
      if (a != b) edges.push_back({a, b});
    }
    piece.first_edge = first;
    piece.edge_count = static_cast<std::uint32_t>(edges.size() - first);
    pieces.push_back(piece);
  }
  soup.edges = std::move(edges);
  const auto collapsed = [&](const SoupPiece& piece) {
    return piece.edge_count < 3 || soup.normal_of(piece) == dvec3(0, 0, 0);
  };
  const auto dropped = std::erase_if(pieces, collapsed);
  soup.pieces = std::move(pieces);
  return dropped;
}

}  // namespace rad::repair
