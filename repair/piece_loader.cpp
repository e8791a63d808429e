#include "repair/piece_loader.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::repair {
namespace {

// As for leader_planes.h: after snapping, what lies within half of T of a plane is in it.
constexpr double kBand = 0.5;
constexpr double kFacingCosine = 0.7;
// A chain of splits deeper than this goes round in a circle.
constexpr int kDeepest = 64;

}  // namespace

PieceLoader::PieceLoader(const Soup& soup, std::span<const std::uint8_t> taken, Complex& complex,
                         Triangulation& triangulation)
    : soup_(soup), complex_(complex), triangulation_(triangulation), triangle_of_(soup.pieces.size(), kNoTriangle) {
  for (const LatticePoint& point : soup.points) complex.add_point(point);
  std::uint32_t triangle = 0;
  for (PieceId id = 0; id < soup.pieces.size(); ++id) {
    const SoupPiece& piece = soup.pieces[id];
    complex.add_piece({kNoCluster, true, piece.rank, piece.source, piece.won, piece.origin});
    if (piece.edge_count != 3) continue;
    if (taken[id]) {
      triangulation.remove_as_it_is(triangle);
    } else {
      triangle_of_[id] = triangle;
      for (const auto& edge : soup.edges_of(piece)) complex.hold(edge[0]);
    }
    ++triangle;
  }
  index_points();
}

void PieceLoader::index_points() {
  first_use_.assign(soup_.points.size() + 1, 0);
  for (PieceId id = 0; id < soup_.pieces.size(); ++id) {
    if (!as_it_is(id)) continue;
    for (const auto& edge : soup_.edges_of(soup_.pieces[id])) ++first_use_[edge[0] + 1];
  }
  for (std::size_t i = 1; i < first_use_.size(); ++i) first_use_[i] += first_use_[i - 1];
  uses_.resize(first_use_.back());
  std::vector<std::uint32_t> next(first_use_.begin(), first_use_.end() - 1);
  for (PieceId id = 0; id < soup_.pieces.size(); ++id) {
    if (!as_it_is(id)) continue;
    for (const auto& edge : soup_.edges_of(soup_.pieces[id])) uses_[next[edge[0]]++] = id;
  }
}

std::span<const PieceId> PieceLoader::pieces_of(PointId point) const {
  if (point + std::size_t{1} >= first_use_.size()) return {};
  return std::span(uses_).subspan(first_use_[point], first_use_[point + 1] - first_use_[point]);
}

void PieceLoader::load(const Soup& part, std::span<const PieceId> pieces, const PlaneClaims& claims) {
  const auto first = static_cast<ClusterId>(complex_.clusters().size());
  for (const LeaderPlane& leader : claims.leaders) complex_.add_cluster(leader.plane, leader.area);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ClusterId own = claims.leader_of_piece[i];
    const bool along = glm::dot(part.normal_of(part.pieces[i]), claims.leaders[own].plane.normal) > 0;
    complex_.place_piece(pieces[i], first + own, along);
    for (const auto& [from, to] : part.edges_of(part.pieces[i])) {
      complex_.toggle(edge_key(from, to), Item::piece(pieces[i]));
    }
  }
}

PointId PieceLoader::now_at(PointId point) const {
  for (auto found = merged_into_.find(point); found != merged_into_.end(); found = merged_into_.find(point)) {
    point = found->second;
  }
  return point;
}

bool PieceLoader::fits(PieceId piece, ClusterId cluster) const {
  const Plane& plane = complex_.clusters()[cluster].plane;
  const dvec3 normal = soup_.normal_of(soup_.pieces[piece]);
  if (std::abs(glm::dot(normal, plane.normal)) < kFacingCosine * glm::length(normal)) return false;
  return std::ranges::all_of(soup_.edges_of(soup_.pieces[piece]), [&](const auto& edge) {
    return std::abs(plane.height(soup_.points[edge[0]])) <= kBand * complex_.tolerance();
  });
}

// The largest plane of a neighbour that the piece fits, the first of equal ones.
ClusterId PieceLoader::home_of(PieceId piece) {
  ClusterId best = kNoCluster;
  const auto consider = [&](ClusterId cluster) {
    if (cluster == best || !fits(piece, cluster)) return;
    const double own = complex_.clusters()[cluster].area;
    const double bests = best == kNoCluster ? -1 : complex_.clusters()[best].area;
    if (own > bests || (own == bests && cluster < best)) best = cluster;
  };
  for (const auto& edge : soup_.edges_of(soup_.pieces[piece])) {
    const PointId id = now_at(edge[0]);
    for (const PointId other : complex_.neighbours(id)) {
      for (const Item item : complex_.items(edge_key(id, other))) {
        if (item.is_piece()) consider(complex_.cluster_of(item));
      }
    }
  }
  if (best != kNoCluster) return best;
  const SoupPiece& own = soup_.pieces[piece];
  const dvec3 normal = soup_.normal_of(own);
  return complex_.add_cluster(Plane(normal, soup_.points[soup_.edges_of(own)[0][0]]), glm::length(normal) / 2);
}

// The chain that the edge has become: what was split where it was shared with a piece of the complex.
void PieceLoader::trace(PointId from, PointId to, Item item, int depth) {
  if (from == to) return;
  const EdgeKey edge = edge_key(from, to);
  const auto split = split_at_.find(edge);
  if (complex_.has_edge(edge) || split == split_at_.end() || depth == kDeepest) {
    complex_.toggle(edge, item);
    return;
  }
  const PointId at = now_at(split->second);
  trace(from, at, item, depth + 1);
  trace(at, to, item, depth + 1);
}

bool PieceLoader::load(PieceId piece) {
  if (!as_it_is(piece)) return false;
  const ClusterId cluster = home_of(piece);
  const SoupPiece& own = soup_.pieces[piece];
  complex_.place_piece(piece, cluster, glm::dot(soup_.normal_of(own), complex_.clusters()[cluster].plane.normal) > 0);
  triangulation_.remove_as_it_is(triangle_of_[piece]);
  triangle_of_[piece] = kNoTriangle;
  for (const auto& [from, to] : soup_.edges_of(own)) {
    complex_.release(from);
    trace(now_at(from), now_at(to), Item::piece(piece), 0);
  }
  return true;
}

bool PieceLoader::follow_changes() {
  std::vector<PieceId> changed;
  const auto splits = complex_.splits_made();
  for (; splits_seen_ < splits.size(); ++splits_seen_) {
    const auto& [edge, at] = splits[splits_seen_];
    split_at_[edge] = at;
    const auto [a, b] = ends_of(edge);
    for (const PieceId piece : pieces_of(a)) {
      const auto edges = soup_.edges_of(soup_.pieces[piece]);
      if (std::ranges::any_of(edges, [&, end = b](const auto& own) { return own[0] == end; })) changed.push_back(piece);
    }
  }
  const auto merges = complex_.merges_made();
  for (; merges_seen_ < merges.size(); ++merges_seen_) {
    const auto& [from, to] = merges[merges_seen_];
    // A point that comes back to life by another merge is itself again.
    merged_into_.erase(to);
    merged_into_[from] = to;
    changed.insert(changed.end(), pieces_of(from).begin(), pieces_of(from).end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  bool any = false;
  for (const PieceId piece : changed) any |= load(piece);
  return any;
}

}  // namespace rad::repair
