#include "repair/pieces_at_fault.h"

namespace rad::repair {
namespace {

void mark_neighbours(const Soup& soup, std::vector<PieceState>& state) {
  std::vector<std::uint8_t> at_fault(soup.points.size(), 0);
  for (PieceId id = 0; id < soup.pieces.size(); ++id) {
    if (state[id] != PieceState::AtFault) continue;
    for (const auto& edge : soup.edges_of(soup.pieces[id])) at_fault[edge[0]] = at_fault[edge[1]] = 1;
  }
  for (PieceId id = 0; id < soup.pieces.size(); ++id) {
    if (state[id] != PieceState::Sound) continue;
    for (const auto& edge : soup.edges_of(soup.pieces[id])) {
      if (at_fault[edge[0]]) state[id] = PieceState::Beside;
    }
  }
}

}  // namespace

std::vector<PieceState> pieces_at_fault(const Soup& soup, const Triangulation& triangulation,
                                        const TriangleLint& lint) {
  std::vector<PieceState> state(soup.pieces.size(), PieceState::Sound);
  for (PieceId id = 0; id < soup.pieces.size(); ++id) {
    if (soup.pieces[id].edge_count != 3) state[id] = PieceState::AtFault;
  }
  lint.for_each_evidence([&](const Evidence& evidence) {
    for (const std::uint32_t i : {evidence.violation.a, evidence.other}) {
      state[triangulation.triangles()[i].winner] = PieceState::AtFault;
    }
  });
  mark_neighbours(soup, state);
  return state;
}

void add_opposite_overlaps(const Soup& soup, const Triangulation& triangulation, const TriangleLint& lint,
                           std::vector<PieceState>& state) {
  if (lint.opposite_overlaps().empty()) return;
  for (const auto& pair : lint.opposite_overlaps()) {
    for (const std::uint32_t i : pair) state[triangulation.triangles()[i].winner] = PieceState::AtFault;
  }
  mark_neighbours(soup, state);
}

std::vector<PieceState> states_around(const Soup& soup, std::span<const PieceId> at_fault) {
  std::vector<PieceState> state(soup.pieces.size(), PieceState::Sound);
  for (const PieceId id : at_fault) state[id] = PieceState::AtFault;
  mark_neighbours(soup, state);
  return state;
}

bool is_fit_unwelded(const Soup& soup, std::span<const std::uint32_t> representative, std::int64_t tolerance) {
  bool any = false;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] == i) continue;
    any = true;
    if (geom::points_within(soup.points[i], soup.points[representative[i]], tolerance)) return false;
  }
  std::vector<Triangle> triangles;
  triangles.reserve(soup.pieces.size());
  for (const SoupPiece& piece : soup.pieces) {
    if (piece.edge_count != 3) return false;
    const auto edges = soup.edges_of(piece);
    triangles.push_back({{edges[0][0], edges[1][0], edges[2][0]}, kNoCluster, true, 0, 0});
  }
  return any && has_no_fault({soup.points, triangles, {}, {}}, tolerance);
}

}  // namespace rad::repair
