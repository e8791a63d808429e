#include "repair/cluster_map.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::repair {
namespace {

using geom::kNoTriangle;
using geom::orient2d;
using geom::Sign;

constexpr std::uint32_t kUnknown = 0xffffffffu;
// Each flip makes one pair better; chains of flips are short, and what is left is cut otherwise.
constexpr int kFlipPasses = 20;

void toggle_in(std::vector<PieceId>& set, PieceId id) {
  const auto at = std::lower_bound(set.begin(), set.end(), id);
  if (at != set.end() && *at == id) {
    set.erase(at);
  } else {
    set.insert(at, id);
  }
}

}  // namespace

ClusterMap::ClusterMap(const Complex& complex, ClusterId cluster) : complex_(complex), cluster_(cluster) {
  gather();
  mesh_ = geom::constrained_delaunay(flat_, edges_);
  note_conflicts();
  spread_covers();
}

void ClusterMap::gather() {
  const Cluster& own = complex_.clusters()[cluster_];
  ids_.assign(own.points.begin(), own.points.end());
  const std::vector<EdgeKey> edges = own.sorted_edges();
  for (const EdgeKey edge : edges) {
    for (const PointId id : ends_of(edge)) ids_.push_back(id);
  }
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  flat_.reserve(ids_.size());
  for (const PointId id : ids_) flat_.push_back(own.plane.project(complex_.point(id)));
  const auto index = [&](PointId id) {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
  };
  edges_.reserve(edges.size());
  for (const EdgeKey edge : edges) {
    const auto [a, b] = ends_of(edge);
    edges_.push_back({index(a), index(b)});
  }
}

void ClusterMap::note_conflicts() {
  for (const auto& [a, b] : mesh_.conflicts.coinciding) stacking_.points.push_back({ids_[a], ids_[b]});
  for (const auto& [edge, point] : mesh_.conflicts.point_on_edge) {
    const auto [a, b] = edges_[edge];
    stacking_.points_on_edges.push_back({edge_key(ids_[a], ids_[b]), ids_[point]});
  }
  stacking_.crossing = !mesh_.conflicts.crossing.empty();
}

std::array<PointId, 3> ClusterMap::points(std::size_t triangle) const {
  const auto& corner = mesh_.triangles[triangle].corner;
  return {ids_[corner[0]], ids_[corner[1]], ids_[corner[2]]};
}

// The cover on the other side of an edge: each of the cluster's pieces on it toggles.
std::uint32_t ClusterMap::crossed(std::uint32_t cover, std::uint32_t triangle, int edge) {
  const geom::PlanarTriangle& t = mesh_.triangles[triangle];
  if (!t.constrained[edge]) return cover;
  const EdgeKey key = edge_key(ids_[t.corner[edge]], ids_[t.corner[(edge + 1) % 3]]);
  for (const Item item : complex_.items(key)) {
    if (item.is_piece() && complex_.cluster_of(item) == cluster_) cover = toggled(cover, item.piece_id());
  }
  return cover;
}

std::uint32_t ClusterMap::toggled(std::uint32_t cover, PieceId piece) {
  const std::uint64_t key = std::uint64_t{cover} << 32 | piece;
  const auto found = toggled_.find(key);
  if (found != toggled_.end()) return found->second;
  std::vector<PieceId> set = covers_[cover];
  toggle_in(set, piece);
  const std::uint32_t beyond = number_of(std::move(set));
  toggled_.emplace(key, beyond);
  toggled_.emplace(std::uint64_t{beyond} << 32 | piece, cover);
  return beyond;
}

std::uint32_t ClusterMap::number_of(std::vector<PieceId> set) {
  if (set.empty()) return 0;
  const auto [entry, is_new] = cover_ids_.try_emplace(set, static_cast<std::uint32_t>(covers_.size()));
  if (is_new) covers_.push_back(std::move(set));
  return entry->second;
}

void ClusterMap::spread_covers() {
  cover_.assign(mesh_.triangles.size(), kUnknown);
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (int edge = 0; edge < 3; ++edge) {
      if (mesh_.triangles[t].neighbour[edge] != kNoTriangle || cover_[t] != kUnknown) continue;
      cover_[t] = crossed(0, t, edge);
      open.push_back(t);
    }
  }
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (int edge = 0; edge < 3; ++edge) {
      const std::uint32_t next = mesh_.triangles[t].neighbour[edge];
      if (next == kNoTriangle || cover_[next] != kUnknown) continue;
      cover_[next] = crossed(cover_[t], t, edge);
      open.push_back(next);
    }
  }
}

// How far p and q are from the segment ab: the nearer of the two.
double ClusterMap::clearance(std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) const {
  const dvec3 from = complex_.place(ids_[a]), to = complex_.place(ids_[b]);
  return std::min(geom::distance_to_segment(complex_.place(ids_[p]), from, to),
                  geom::distance_to_segment(complex_.place(ids_[q]), from, to));
}

bool ClusterMap::flip_if_better(std::uint32_t triangle, int edge, double tolerance) {
  const geom::PlanarTriangle& t = mesh_.triangles[triangle];
  const std::uint32_t other = t.neighbour[edge];
  if (other == kNoTriangle || t.constrained[edge]) return false;
  const std::uint32_t a = t.corner[edge], b = t.corner[(edge + 1) % 3], p = t.corner[(edge + 2) % 3];
  std::uint32_t q = a;
  for (const std::uint32_t corner : mesh_.triangles[other].corner) {
    if (corner != a && corner != b) q = corner;
  }
  const double now = clearance(a, b, p, q);
  if (now > tolerance) return false;
  const Sign at_a = orient2d(flat_[p], flat_[q], flat_[a]), at_b = orient2d(flat_[p], flat_[q], flat_[b]);
  if (at_a == Sign::Zero || at_b == Sign::Zero || at_a == at_b) return false;
  if (clearance(p, q, a, b) <= now) return false;
  mesh_.flip(triangle, edge);
  return true;
}

void ClusterMap::flip_slivers(double tolerance) {
  bool flipped = true;
  for (int pass = 0; pass < kFlipPasses && flipped; ++pass) {
    flipped = false;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (int edge = 0; edge < 3; ++edge) {
        if (mesh_.triangles[t].neighbour[edge] > t) flipped |= flip_if_better(t, edge, tolerance);
      }
    }
  }
}

}  // namespace rad::repair
