#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

#include "geom/planar_delaunay.h"
#include "geom/planar_mesh.h"

namespace rad::geom {
namespace {

// Fewer points are near enough to each other in whatever order they come.
constexpr std::size_t kSortedFrom = 64;

// Place along Hilbert's curve of 16 bits a side.
std::uint32_t hilbert(std::uint32_t x, std::uint32_t y) {
  std::uint32_t along = 0;
  for (std::uint32_t side = 1u << 15; side > 0; side /= 2) {
    const bool right = (x & side) != 0, up = (y & side) != 0;
    along += side * side * ((right ? 3u : 0u) ^ (up ? 1u : 0u));
    if (up) continue;
    if (right) {
      x = 0xffffu - x;
      y = 0xffffu - y;
    }
    std::swap(x, y);
  }
  return along;
}

class Builder {
 public:
  Builder(std::span<const PlanarPoint> points, std::span<const std::array<std::uint32_t, 2>> edges)
      : points_(points), edges_(edges), representative_(points.size()), delaunay_(points) {}

  PlanarMesh build() {
    find_coinciding();
    if (!delaunay_.insert(order())) return std::move(mesh_);
    insert_edges();
    mesh_.triangles = delaunay_.triangles();
    return std::move(mesh_);
  }

 private:
  void find_coinciding() {
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return std::tie(points_[a], a) < std::tie(points_[b], b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && points_[order[i]] == points_[order[i - 1]];
      representative_[order[i]] = same ? representative_[order[i - 1]] : order[i];
      if (same) mesh_.conflicts.coinciding.push_back({representative_[order[i]], order[i]});
    }
  }

  // Rounds of points spread all over, each twice as many as the one before, each along a curve: every search is short,
  // and no row of points meets long thin triangles only.
  [[nodiscard]] std::vector<std::uint32_t> order() const {
    std::vector<std::uint32_t> order;
    order.reserve(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (representative_[i] == i) order.push_back(i);
    }
    if (order.size() < kSortedFrom) return order;
    PlanarPoint low = points_[0], high = low;
    for (const PlanarPoint& p : points_) {
      low = {std::min(low.u, p.u), std::min(low.v, p.v)};
      high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
    const auto extent = static_cast<std::uint64_t>(std::max({high.u - low.u, high.v - low.v, std::int64_t{1}}));
    const int shift = std::max(0, static_cast<int>(std::bit_width(extent)) - 16);
    std::vector<std::uint64_t> keys(points_.size());
    const auto rounds = static_cast<int>(std::bit_width(order.size() / kSortedFrom));
    for (const std::uint32_t i : order) {
      const std::uint32_t scattered = i * 0x9e3779b1u;
      const auto early = static_cast<std::uint64_t>(std::min(std::countl_zero(scattered | 1u), rounds));
      const auto x = static_cast<std::uint32_t>((points_[i].u - low.u) >> shift);
      const auto y = static_cast<std::uint32_t>((points_[i].v - low.v) >> shift);
      keys[i] = (static_cast<std::uint64_t>(rounds) - early) << 32 | hilbert(x, y);
    }
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::tie(keys[a], a) < std::tie(keys[b], b); });
    return order;
  }

  void insert_edges() {
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      const KeptEdge kept = delaunay_.keep(representative_[edges_[edge][0]], representative_[edges_[edge][1]]);
      if (kept == KeptEdge::Crossed) mesh_.conflicts.crossing.push_back(edge);
      if (kept == KeptEdge::Split) note_points_on(edge);
    }
  }

  // Rare, so a walk over all points is good enough.
  void note_points_on(std::uint32_t edge) {
    const PlanarPoint a = points_[edges_[edge][0]], b = points_[edges_[edge][1]];
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const PlanarPoint p = points_[i];
      if (p == a || p == b || orient2d(a, b, p) != Sign::Zero) continue;
      const auto along = (p.u - a.u) * (b.u - a.u) + (p.v - a.v) * (b.v - a.v);
      const auto back = (p.u - b.u) * (a.u - b.u) + (p.v - b.v) * (a.v - b.v);
      if (along > 0 && back > 0) mesh_.conflicts.point_on_edge.push_back({edge, i});
    }
  }

  std::span<const PlanarPoint> points_;
  std::span<const std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> representative_;
  PlanarDelaunay delaunay_;
  PlanarMesh mesh_;
};

}  // namespace

PlanarMesh constrained_delaunay(std::span<const PlanarPoint> points,
                                std::span<const std::array<std::uint32_t, 2>> edges) {
  return Builder(points, edges).build();
}

}  // namespace rad::geom
