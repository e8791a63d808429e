#include "repair/soup.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::repair {

namespace {

bool first_component_negative(const dvec3& v) { return v.x != 0 ? v.x < 0 : v.y != 0 ? v.y < 0 : v.z < 0; }

}  // namespace

dvec3 Soup::newell_normal(const SoupPiece& piece) const {
  const auto own = edges_of(piece);
  const dvec3 base = geom::as_vector(points[own.front()[0]]);
  dvec3 sum(0, 0, 0);
  for (const auto& [from, to] : own) {
    sum += glm::cross(geom::as_vector(points[from]) - base, geom::as_vector(points[to]) - base);
  }
  return sum;
}

// The largest of the triangles that two edges in a row span, with the sign of the whole.
dvec3 Soup::normal_of_crossing_rings(const SoupPiece& piece) const {
  const auto own = edges_of(piece);
  dvec3 largest(0, 0, 0);
  for (const auto& [a, b] : own) {
    for (const auto& [from, to] : own) {
      if (from != b) continue;
      const dvec3 spanned = glm::cross(geom::as_vector(points[b]) - geom::as_vector(points[a]),
                                       geom::as_vector(points[to]) - geom::as_vector(points[from]));
      if (glm::dot(spanned, spanned) > glm::dot(largest, largest)) largest = spanned;
    }
  }
  const double agreement = glm::dot(largest, newell_normal(piece));
  const bool turn = agreement != 0 ? agreement < 0 : first_component_negative(largest);
  return turn ? -largest : largest;
}

dvec3 Soup::normal_of(const SoupPiece& piece) const {
  return piece.edge_count == 3 ? newell_normal(piece) : normal_of_crossing_rings(piece);
}

std::array<LatticePoint, 3> Soup::triangle(const SoupPiece& piece) const {
  const auto own = edges_of(piece);
  return {points[own[0][0]], points[own[1][0]], points[own[2][0]]};
}

void Soup::note_origins() {
  for (SoupPiece& piece : pieces) {
    if (piece.edge_count != 3) continue;
    piece.origin = static_cast<std::uint32_t>(origins.size());
    origins.push_back(triangle(piece));
  }
}

Soup part_of(const Soup& soup, std::span<const std::uint32_t> pieces) {
  Soup part;
  part.points = soup.points;
  for (const std::uint32_t i : pieces) {
    SoupPiece piece = soup.pieces[i];
    const auto own = soup.edges_of(piece);
    piece.first_edge = static_cast<std::uint32_t>(part.edges.size());
    part.edges.insert(part.edges.end(), own.begin(), own.end());
    part.pieces.push_back(piece);
  }
  return part;
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
