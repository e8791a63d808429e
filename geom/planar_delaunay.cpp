#include "geom/planar_delaunay.h"

#include <algorithm>
#include <cmath>

namespace rad::geom {

// Differences are below 2^26, so squares, products and their sums of two are exact in double numbers. Only the last
// three products round: where their sum is not clear of that, integers tell.
bool PlanarDelaunay::in_circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  const PlanarPoint& o = points_[d];
  const std::int64_t au = points_[a].u - o.u, av = points_[a].v - o.v, bu = points_[b].u - o.u, bv = points_[b].v - o.v,
                     cu = points_[c].u - o.u, cv = points_[c].v - o.v;
  const std::int64_t bc = bu * cv - bv * cu, ca = cu * av - cv * au, ab = au * bv - av * bu;
  const std::int64_t aa = au * au + av * av, bb = bu * bu + bv * bv, cc = cu * cu + cv * cv;
  const double x = static_cast<double>(aa) * static_cast<double>(bc),
               y = static_cast<double>(bb) * static_cast<double>(ca),
               z = static_cast<double>(cc) * static_cast<double>(ab);
  const double sum = x + y + z;
  constexpr double kRounding = 0x1p-50;  // five roundings of at most 2^-53 each, of sums no larger than this one
  if (std::abs(sum) > kRounding * (std::abs(x) + std::abs(y) + std::abs(z))) return sum > 0;
  return Int128{aa} * bc + Int128{bb} * ca + Int128{cc} * ab > 0;
}

bool PlanarDelaunay::is_finite(const PlanarTriangle& triangle) const {
  return triangle.corner[0] != infinite_ && triangle.corner[1] != infinite_ && triangle.corner[2] != infinite_;
}

// The circle of a triangle outside of the hull is the open half plane beyond its edge, and the inside of that edge.
bool PlanarDelaunay::in_conflict(const PlanarTriangle& triangle, std::uint32_t point) const {
  const auto& c = triangle.corner;
  for (std::size_t i = 0; i < 3; ++i) {
    if (c[i] != infinite_) continue;
    const std::uint32_t from = c[(i + 1) % 3], to = c[(i + 2) % 3];
    const Sign side = turn(from, to, point);
    if (side != Sign::Zero) return side == Sign::Positive;
    const auto [low, high] = std::minmax(points_[from], points_[to]);
    return low < points_[point] && points_[point] < high;
  }
  return in_circle(c[0], c[1], c[2], point);
}

bool PlanarDelaunay::make_first(std::vector<std::uint32_t>& order) {
  if (order.size() < 3) return false;
  const auto third = std::find_if(order.begin() + 2, order.end(),
                                  [&](std::uint32_t point) { return turn(order[0], order[1], point) != Sign::Zero; });
  if (third == order.end()) return false;
  std::uint32_t a = order[0], b = order[1];
  const std::uint32_t c = *third;
  if (turn(a, b, c) == Sign::Negative) std::swap(a, b);
  triangles_.push_back({{a, b, c}, {1, 2, 3}, {}});
  triangles_.push_back({{b, a, infinite_}, {0, 3, 2}, {}});
  triangles_.push_back({{c, b, infinite_}, {0, 1, 3}, {}});
  triangles_.push_back({{a, c, infinite_}, {0, 2, 1}, {}});
  order.erase(third);
  order.erase(order.begin(), order.begin() + 2);
  return true;
}

bool PlanarDelaunay::insert(std::vector<std::uint32_t> order) {
  if (!make_first(order)) return false;
  triangle_of_.resize(points_.size() + 1);
  triangles_.reserve(2 * order.size() + 4);
  dug_.resize(4, 0);
  dug_.reserve(triangles_.capacity());
  for (const std::uint32_t point : order) insert(point);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (const std::uint32_t corner : triangles_[i].corner) triangle_of_[corner] = i;
  }
  return true;
}

void PlanarDelaunay::insert(std::uint32_t point) {
  dig(find(point), point);
  fill_star(point);
}

// A walk that always steps to the side where the point is; among Delaunay triangles it comes to an end.
std::uint32_t PlanarDelaunay::find(std::uint32_t point) const {
  std::uint32_t here = last_, before = kNoTriangle;
  while (true) {
    const PlanarTriangle& t = triangles_[here];
    std::uint32_t next = kNoTriangle;
    for (std::size_t i = 0; i < 3 && next == kNoTriangle; ++i) {
      if (t.neighbour[i] == before) continue;
      if (turn(t.corner[i], t.corner[(i + 1) % 3], point) == Sign::Negative) next = t.neighbour[i];
    }
    if (next == kNoTriangle) return here;
    if (!is_finite(triangles_[next])) return next;
    before = here;
    here = next;
  }
}

// Takes out the triangles in conflict, which hang together.
void PlanarDelaunay::dig(std::uint32_t first, std::uint32_t point) {
  ++round_;
  cavity_.assign(1, first);
  rim_.clear();
  dug_[first] = round_;
  for (std::size_t at = 0; at < cavity_.size(); ++at) {
    const PlanarTriangle& t = triangles_[cavity_[at]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t other = t.neighbour[i];
      if (dug(other)) continue;
      if (in_conflict(triangles_[other], point)) {
        dug_[other] = round_;
        cavity_.push_back(other);
      } else {
        rim_.push_back({t.corner[i], t.corner[(i + 1) % 3], other});
      }
    }
  }
}

// The side of a triangle that starts at a corner of its.
std::uint32_t PlanarDelaunay::side_of(std::uint32_t triangle, std::uint32_t from) const {
  const auto& corner = triangles_[triangle].corner;
  return corner[0] == from ? 0 : corner[1] == from ? 1 : 2;
}

void PlanarDelaunay::fill_star(std::uint32_t point) {
  std::size_t used = 0;
  for (const Rim& rim : rim_) {
    std::uint32_t place = 0;
    if (used < cavity_.size()) {
      place = cavity_[used++];
    } else {
      place = static_cast<std::uint32_t>(triangles_.size());
      triangles_.emplace_back();
      dug_.push_back(0);
    }
    triangles_[place] = {{rim.from, rim.to, point}, {rim.outer, kNoTriangle, kNoTriangle}, {}};
    triangles_[rim.outer].neighbour[side_of(rim.outer, rim.to)] = place;
    triangle_of_[rim.from] = place;
    if (rim.from != infinite_ && rim.to != infinite_) last_ = place;
  }
  for (const Rim& rim : rim_) {
    const std::uint32_t here = triangle_of_[rim.from], next = triangle_of_[rim.to];
    triangles_[here].neighbour[1] = next;
    triangles_[next].neighbour[2] = here;
  }
}

std::vector<PlanarTriangle> PlanarDelaunay::triangles() const {
  std::vector<std::uint32_t> number(triangles_.size(), kNoTriangle);
  std::vector<PlanarTriangle> finite;
  finite.reserve(triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    if (!is_finite(triangles_[i])) continue;
    number[i] = static_cast<std::uint32_t>(finite.size());
    finite.push_back(triangles_[i]);
  }
  for (PlanarTriangle& triangle : finite) {
    for (std::uint32_t& other : triangle.neighbour) other = number[other];
  }
  return finite;
}

}  // namespace rad::geom
