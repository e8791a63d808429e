#include "validate/rings.h"

#include <algorithm>
#include <utility>

namespace rad::validate {
namespace {

using geom::orient2d;
using geom::PlanarPoint;
using geom::Sign;

struct RingEdge {
  PlanarPoint from;
  PlanarPoint to;

  [[nodiscard]] std::int64_t low_u() const { return std::min(from.u, to.u); }
  [[nodiscard]] std::int64_t high_u() const { return std::max(from.u, to.u); }
};

bool opposite(Sign a, Sign b) { return a != Sign::Zero && b == -a; }

bool cross_properly(const RingEdge& a, const RingEdge& b) {
  return opposite(orient2d(a.from, a.to, b.from), orient2d(a.from, a.to, b.to)) &&
         opposite(orient2d(b.from, b.to, a.from), orient2d(b.from, b.to, a.to));
}

std::vector<RingEdge> edges_of(std::span<const PlanarPoint> points, std::span<const Ring> rings) {
  std::vector<RingEdge> edges;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({points[ring[i]], points[ring[(i + 1) % ring.size()]]});
    }
  }
  return edges;
}

bool on_segment(const PlanarPoint& point, const RingEdge& edge) {
  return orient2d(edge.from, edge.to, point) == Sign::Zero && point.u >= edge.low_u() && point.u <= edge.high_u() &&
         point.v >= std::min(edge.from.v, edge.to.v) && point.v <= std::max(edge.from.v, edge.to.v);
}

}  // namespace

bool edges_cross(std::span<const PlanarPoint> points, std::span<const Ring> rings) {
  std::vector<RingEdge> edges = edges_of(points, rings);
  std::sort(edges.begin(), edges.end(), [](const RingEdge& a, const RingEdge& b) { return a.low_u() < b.low_u(); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].low_u() <= edges[i].high_u(); ++j) {
      if (cross_properly(edges[i], edges[j])) return true;
    }
  }
  return false;
}

bool is_convex(std::span<const PlanarPoint> points, const Ring& ring, bool strict) {
  // One turning direction at every corner, and the edge directions go around once: their half-plane changes twice.
  Sign turn = Sign::Zero;
  int changes = 0;
  bool upward_before = false;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanarPoint& a = points[ring[i]];
    const PlanarPoint& b = points[ring[(i + 1) % n]];
    const PlanarPoint& c = points[ring[(i + 2) % n]];
    if (a == b) return false;
    const Sign here = orient2d(a, b, c);
    if (here == Sign::Zero) {
      if (strict) return false;
      // In line: forward is fine, backward is a spike.
      if ((b.u - a.u) * (c.u - b.u) + (b.v - a.v) * (c.v - b.v) <= 0) return false;
    } else {
      if (turn == Sign::Zero) turn = here;
      if (here != turn) return false;
    }
    const bool upward = b.v > a.v || (b.v == a.v && b.u > a.u);
    if (i > 0 && upward != upward_before) ++changes;
    upward_before = upward;
  }
  return turn != Sign::Zero && changes <= 2;
}

bool inside_or_on(std::span<const PlanarPoint> points, const Ring& ring, const PlanarPoint& point) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    RingEdge edge{points[ring[i]], points[ring[(i + 1) % ring.size()]]};
    if (on_segment(point, edge)) return true;
    if (edge.from.v > edge.to.v) std::swap(edge.from, edge.to);
    if (edge.from.v <= point.v && point.v < edge.to.v && orient2d(edge.from, edge.to, point) == Sign::Positive) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace rad::validate
