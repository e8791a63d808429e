// Re-homing: a triangle that nearly lies in another cluster's plane becomes a triangle of that cluster, where overlaps
// are resolved exactly, instead of being cut by a plane that it hardly leaves.

#include <algorithm>
#include <cmath>

#include "repair/distance.h"
#include "repair/residual_round.h"

namespace rad::repair {
namespace {

constexpr double kPlaneBand = 2;           // T: all corners are this near the target plane
constexpr double kForcedBand = 3;          // T: or this near the plane of the other triangle, by force
constexpr double kFacingCosine = 0.7;      // and the triangle is turned from the plane by less than 45°
constexpr double kFlatSpread = 2.5;        // T: triangles within this height of each other may overlap
constexpr double kFarthestInCluster = 16;  // T: points that merging drew off their plane are no farther from it
constexpr double kFarOverlap = 3;          // T: others are no place for the triangle where they are this far over it

using geom::orient2d;
using geom::PlanarPoint;
using geom::Sign;
using Flat = std::array<PlanarPoint, 3>;

bool strictly_inside(const PlanarPoint& p, const Flat& t) {
  const Sign a = orient2d(t[0], t[1], p), b = orient2d(t[1], t[2], p), c = orient2d(t[2], t[0], p);
  return a != Sign::Zero && a == b && b == c;
}

}  // namespace

bool Residual::Round::fits_plane(const Triangle& t, const Triangle& other) const {
  const Plane& target = plane(other.cluster);
  const dvec3 own = normal(t);
  if (std::abs(glm::dot(own, target.normal)) <= kFacingCosine) return false;
  const double tolerance = complex.tolerance();
  const bool in_band = std::ranges::all_of(
      t.points, [&](PointId id) { return std::abs(target.height(complex.point(id))) <= kPlaneBand * tolerance; });
  if (in_band) return true;
  const dvec3 others = normal(other);
  return effort == Effort::Forced && std::abs(glm::dot(others, target.normal)) > kFacingCosine &&
         std::ranges::all_of(
             t.points, [&](PointId id) { return std::abs(height(other, others, id)) <= kForcedBand * tolerance; });
}

// A triangle of the target's that lies over or under `t` by more than a few T: then `t` would be lost in it.
bool Residual::Round::overlaps_far(const Triangle& t, ClusterId target) const {
  const Plane& onto = plane(target);
  const double tolerance = complex.tolerance();
  const auto flat = [&](const Triangle& triangle) {
    return Flat{onto.project(complex.point(triangle.points[0])), onto.project(complex.point(triangle.points[1])),
                onto.project(complex.point(triangle.points[2]))};
  };
  const auto heights = [&](const Triangle& triangle) {
    std::array<double, 3> h{};
    for (std::size_t i = 0; i < 3; ++i) h[i] = onto.height(complex.point(triangle.points[i]));
    return std::minmax({h[0], h[1], h[2]});
  };
  const auto far_corner_inside = [&](const Triangle& of, const Triangle& in) {
    return std::ranges::any_of(of.points, [&](PointId id) {
      return strictly_inside(onto.project(complex.point(id)), flat(in)) &&
             distance_to_triangle(complex.place(id), corners(in)) > kFarOverlap * tolerance;
    });
  };
  const Flat own = flat(t);
  if (orient2d(own[0], own[1], own[2]) == Sign::Zero) return true;
  const auto [low, high] = heights(t);
  bool far = false;
  const auto inflation = static_cast<std::int32_t>(std::ceil(kFarthestInCluster * tolerance));
  residual.search_.update(triangulation);
  residual.search_.for_each_meeting(residual.search_.box(t, inflation), [&](const Triangle& y) {
    if (far || y.cluster != target) return;
    const auto [y_low, y_high] = heights(y);
    if (std::max(high - y_low, y_high - low) <= kFlatSpread * tolerance) return;
    far = far_corner_inside(t, y) || far_corner_inside(y, t);
  });
  return far;
}

bool Residual::Round::rehome_one(std::uint32_t which, std::uint32_t other) {
  const Triangle t = triangle(which);
  const ClusterId target = triangle(other).cluster;
  if (!fits_plane(t, triangle(other)) || overlaps_far(t, target)) return false;
  TriangleKey key = t.points;
  std::sort(key.begin(), key.end());
  if (!residual.rehomed_.insert({key, target}).second) return false;
  const auto toggle_edges = [&](PieceId piece) {
    for (std::size_t k = 0; k < 3; ++k) {
      complex.toggle(edge_key(t.points[k], t.points[(k + 1) % 3]), Item::piece(piece));
    }
  };
  Piece moved_piece = complex.pieces()[t.winner];
  for (const PieceId piece : triangulation.cover_of(t)) {
    if (complex.pieces()[piece].along == t.along) toggle_edges(piece);
  }
  moved_piece.cluster = target;
  moved_piece.along = glm::dot(normal(t), plane(target).normal) > 0;
  toggle_edges(complex.add_piece(moved_piece));
  moved[which] = true;
  changed = true;
  ++residual.counts_.rehomed;
  return true;
}

// From the higher cluster to the lower first: lower ones are of larger faces.
bool Residual::Round::rehome(const Violation& violation) {
  const ClusterId a = triangle(violation.a).cluster, b = triangle(violation.b).cluster;
  if (a == b) return false;
  const std::uint32_t high = a > b ? violation.a : violation.b, low = a > b ? violation.b : violation.a;
  return rehome_one(high, low) || rehome_one(low, high);
}

}  // namespace rad::repair
