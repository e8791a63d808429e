#include "corpus/judge/exact_meeting.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rad::corpus {
namespace {

using geom::LatticePoint;

// |coordinate| < 2^23: differences 2^24, products of two 2^49, of three 2^75.
__extension__ using Wide = __int128;
using Vector = std::array<Wide, 3>;

Vector operator-(const LatticePoint& to, const LatticePoint& from) {
  return {Wide{to.x} - from.x, Wide{to.y} - from.y, Wide{to.z} - from.z};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Wide dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int sign(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

Vector normal(const TriangleCorners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

Wide magnitude(Wide value) { return value < 0 ? -value : value; }

std::size_t largest_axis(const Vector& n) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (magnitude(n[i]) > magnitude(n[axis])) axis = i;
  }
  return axis;
}

/// Turns of points of one plane, seen along an axis that is not in the plane.
class Planar {
 public:
  explicit Planar(const Vector& normal) : axis_(largest_axis(normal)) {}

  [[nodiscard]] int turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) const {
    return sign(cross(b - a, c - a)[axis_]);
  }
  [[nodiscard]] bool on_segment(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b) const {
    return turn(a, b, p) == 0 && dot(p - a, p - b) <= 0;
  }
  [[nodiscard]] bool segments_meet(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                                   const LatticePoint& d) const {
    if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) return true;
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }
  [[nodiscard]] bool inside(const LatticePoint& p, const TriangleCorners& t) const {
    const int u = turn(t[0], t[1], p), v = turn(t[1], t[2], p), w = turn(t[2], t[0], p);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  }

 private:
  std::size_t axis_;
};

bool segment_meets_in_plane(const LatticePoint& from, const LatticePoint& to, const TriangleCorners& t) {
  const Planar plane(normal(t));
  if (plane.inside(from, t) || plane.inside(to, t)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (plane.segments_meet(from, to, t[i], t[(i + 1) % 3])) return true;
  }
  return false;
}

bool any_edge_meets(const TriangleCorners& edges_of, const TriangleCorners& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets_triangle(edges_of[i], edges_of[(i + 1) % 3], t)) return true;
  }
  return false;
}

// The corners with the common ones first.
TriangleCorners sorted_by_common(const TriangleCorners& t, const TriangleCorners& other, std::size_t& common) {
  TriangleCorners result = t;
  const auto shared = [&](const LatticePoint& p) { return std::ranges::find(other, p) != other.end(); };
  common = static_cast<std::size_t>(std::ranges::count_if(t, shared));
  std::stable_partition(result.begin(), result.end(), shared);
  return result;
}

}  // namespace

bool has_no_area(const TriangleCorners& triangle) { return normal(triangle) == Vector{0, 0, 0}; }

bool segment_meets_triangle(const LatticePoint& from, const LatticePoint& to, const TriangleCorners& t) {
  const Vector n = normal(t);
  const int side_from = sign(dot(n, from - t[0])), side_to = sign(dot(n, to - t[0]));
  if (side_from == 0 && side_to == 0) return segment_meets_in_plane(from, to, t);
  if (side_from * side_to > 0) return false;
  // The line passes all edges on one side where it passes through the triangle.
  int least = 1, most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sign(dot(cross(t[i] - from, t[(i + 1) % 3] - from), to - from));
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least >= 0 || most <= 0;
}

bool meet_improperly(const TriangleCorners& first, const TriangleCorners& second) {
  std::size_t common = 0;
  const TriangleCorners a = sorted_by_common(first, second, common);
  const TriangleCorners b = sorted_by_common(second, first, common);
  if (common == 0) return any_edge_meets(a, b) || any_edge_meets(b, a);
  if (common == 1) return segment_meets_triangle(a[1], a[2], b) || segment_meets_triangle(b[1], b[2], a);
  // A common edge: bad only where both lie in one plane on one side of it.
  const Vector n = normal(a);
  if (dot(n, b[2] - b[0]) != 0) return false;
  const Planar plane(n);
  return plane.turn(a[0], a[1], a[2]) == plane.turn(a[0], a[1], b[2]);
}

}  // namespace rad::corpus
