#include "validate/interior_ray.h"

namespace rad::validate {
namespace {

using geom::IntVector;
using geom::LatticePoint;
using geom::PlanarPoint;
using geom::Sign;

std::int64_t component(const IntVector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

std::int64_t floor_third(std::int64_t value) { return value >= 0 ? value / 3 : -((2 - value) / 3); }

PlanarPoint tripled(const LatticePoint& point, int dropped) {
  const PlanarPoint p = geom::project(point, dropped);
  return {3 * p.u, 3 * p.v};
}

// orient2d(a, b, p) where p is moved by (ε, ε²): zero only where a and b are the same.
Sign orient_beside(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& p) {
  const Sign sign = geom::orient2d(a, b, p);
  if (sign != Sign::Zero) return sign;
  return a.v != b.v ? geom::sign_of(a.v - b.v) : geom::sign_of(b.u - a.u);
}

}  // namespace

InteriorRay::InteriorRay(const std::array<LatticePoint, 3>& triangle, bool in_front) {
  for (const LatticePoint& corner : triangle) {
    start_ = {start_[0] + corner.x, start_[1] + corner.y, start_[2] + corner.z};
  }
  const IntVector normal = geom::TrianglePlane(triangle[0], triangle[1], triangle[2]).normal;
  axis_ = geom::dominant_axis(normal);
  upward_ = (component(normal, axis_) > 0) == in_front;
}

geom::LatticeBox InteriorRay::box() const {
  geom::LatticeBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = static_cast<std::int32_t>(floor_third(start_[i]));
    box.high[i] = static_cast<std::int32_t>(floor_third(start_[i] + 2));
  }
  const auto along = static_cast<std::size_t>(axis_);
  if (upward_) {
    box.high[along] = geom::kLatticeLimit;
  } else {
    box.low[along] = -geom::kLatticeLimit;
  }
  return box;
}

bool InteriorRay::passes_in_projection(const std::array<LatticePoint, 3>& triangle) const {
  const PlanarPoint p = axis_ == 0   ? PlanarPoint{start_[1], start_[2]}
                        : axis_ == 1 ? PlanarPoint{start_[2], start_[0]}
                                     : PlanarPoint{start_[0], start_[1]};
  std::array<Sign, 3> signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    signs[i] = orient_beside(tripled(triangle[i], axis_), tripled(triangle[(i + 1) % 3], axis_), p);
  }
  return signs[0] != Sign::Zero && signs[0] == signs[1] && signs[1] == signs[2];
}

bool InteriorRay::passes(const std::array<LatticePoint, 3>& triangle) const {
  if (!passes_in_projection(triangle)) return false;
  const LatticePoint& through = triangle[0];
  const IntVector normal = geom::TrianglePlane(triangle[0], triangle[1], triangle[2]).normal;
  const IntVector from_plane{start_[0] - std::int64_t{3} * through.x, start_[1] - std::int64_t{3} * through.y,
                             start_[2] - std::int64_t{3} * through.z};
  const bool start_above = geom::dot(normal, from_plane) > 0;
  const bool towards_normal = (component(normal, axis_) > 0) == upward_;
  return start_above != towards_normal;
}

}  // namespace rad::validate
