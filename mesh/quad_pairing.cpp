#include "mesh/quad_pairing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace rad::mesh {
namespace {

using geom::PlanePoint;
using Quad = std::array<std::uint32_t, 4>;

// Where the common edge is longer than allowed, a quadrilateral of this shape is still better than another point.
constexpr double kShapeForLongEdge = 0.3;

// A thin rectangle scores √½ of its two halves and is no worse a radiator for it.
constexpr double kShareOfTriangles = 0.7;

struct Pair {
  double shape;
  std::uint32_t triangle, partner;
};

double corner_cosine(const PlanePoint& at, const PlanePoint& a, const PlanePoint& b) {
  const double ax = a.x - at.x, ay = a.y - at.y, bx = b.x - at.x, by = b.y - at.y;
  return (ax * bx + ay * by) / (std::hypot(ax, ay) * std::hypot(bx, by));
}

class QuadJudge {
 public:
  QuadJudge(const FacePoints& points, const PairingLimits& limits) : points_(points), limits_(limits) {}

  [[nodiscard]] bool admissible(const Quad& quad) const {
    static const double kLeastCosine = std::cos(kWidestQuadCorner * std::numbers::pi / 180);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t before = quad[(i + 3) % 4], at = quad[i], after = quad[(i + 1) % 4];
      if (geom::orient2d(points_.flat[before], points_.flat[at], points_.flat[after]) != geom::Sign::Positive ||
          corner_cosine(points_.plane[at], points_.plane[before], points_.plane[after]) < kLeastCosine) {
        return false;
      }
    }
    const geom::TrianglePlane plane(points_.lattice[quad[0]], points_.lattice[quad[1]], points_.lattice[quad[2]]);
    return geom::side_of_plane_within(plane, points_.lattice[quad[3]], limits_.flatness) == geom::Sign::Zero;
  }

  template <std::size_t count>
  [[nodiscard]] double shape(const std::array<std::uint32_t, count>& corners) const {
    std::array<PlanePoint, count> place;
    for (std::size_t i = 0; i < count; ++i) place[i] = points_.plane[corners[i]];
    return geom::scaled_shape(place);
  }

  [[nodiscard]] bool is_long(std::uint32_t a, std::uint32_t b) const {
    const PlanePoint &p = points_.plane[a], &q = points_.plane[b];
    return std::hypot(q.x - p.x, q.y - p.y) > limits_.longest;
  }

 private:
  const FacePoints& points_;
  const PairingLimits& limits_;
};

std::vector<Pair> worthwhile_pairs(std::span<const LinkedTriangle> triangles, const QuadJudge& judge) {
  std::vector<Pair> pairs;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t s = triangles[t].across[edge];
      if (s == kNoTriangle || s < t || triangles[t].fixed[edge]) continue;
      const Quad quad = quad_over(triangles, t, edge);
      if (!judge.admissible(quad)) continue;
      const double shape = judge.shape(quad);
      const double worse = std::min(judge.shape(triangles[t].corner), judge.shape(triangles[s].corner));
      const bool saves_division = judge.is_long(quad[0], quad[2]) && shape >= kShapeForLongEdge;
      if (shape >= kShareOfTriangles * worse || saves_division) pairs.push_back({shape, t, s});
    }
  }
  return pairs;
}

}  // namespace

Quad quad_over(std::span<const LinkedTriangle> triangles, std::uint32_t triangle, std::size_t edge) {
  const LinkedTriangle& here = triangles[triangle];
  const LinkedTriangle& there = triangles[here.across[edge]];
  const std::uint32_t a = here.corner[edge], b = here.corner[(edge + 1) % 3];
  return {a, there.opposite(there.edge_from(b, a)), b, here.opposite(edge)};
}

std::vector<std::uint32_t> quad_partners(std::span<const LinkedTriangle> triangles, const FacePoints& points,
                                         const PairingLimits& limits) {
  std::vector<Pair> pairs = worthwhile_pairs(triangles, QuadJudge(points, limits));
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(b.shape, a.triangle, a.partner) < std::tie(a.shape, b.triangle, b.partner);
  });
  std::vector<std::uint32_t> partner(triangles.size(), kNoTriangle);
  for (const Pair& pair : pairs) {
    if (partner[pair.triangle] != kNoTriangle || partner[pair.partner] != kNoTriangle) continue;
    partner[pair.triangle] = pair.partner;
    partner[pair.partner] = pair.triangle;
  }
  return partner;
}

}  // namespace rad::mesh
