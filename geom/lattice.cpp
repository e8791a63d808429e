#include "geom/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rad::geom {
namespace {

// Half the box, without the overflow that (high - low) has for coordinates near the end of the double range.
dvec3 half_extent(const Box& box) { return box.high * 0.5 - box.low * 0.5; }

double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The multiple of `step` nearest to `value`. Beyond the last multiple that double holds it is the one before: then the
// box ends within a step from there. Zero is +0, for the sign of the other would hang on the order of the vertices and
// show in what is written.
double nearest_multiple(double value, double step) {
  const double nearest = std::nearbyint(value / step) * step;
  return (std::isfinite(nearest) ? nearest : std::trunc(value / step) * step) + 0.0;
}

}  // namespace

double Box::diagonal() const {
  if (empty()) return 0;
  const dvec3 half = half_extent(*this);
  return 2 * std::hypot(half.x, half.y, half.z);
}

double Box::largest_magnitude() const { return empty() ? 0 : std::max(largest(low), largest(high)); }

void Box::add(const dvec3& point) {
  if (empty()) {
    low = high = point;
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], point[axis]);
    high[axis] = std::max(high[axis], point[axis]);
  }
}

LatticePoint Lattice::nearest(const dvec3& point) const {
  const dvec3 scaled = (point - origin) / pitch;
  return {static_cast<std::int32_t>(std::lround(scaled.x)), static_cast<std::int32_t>(std::lround(scaled.y)),
          static_cast<std::int32_t>(std::lround(scaled.z))};
}

dvec3 Lattice::position(const LatticePoint& point) const { return origin + pitch * dvec3(point.x, point.y, point.z); }

Lattice lattice_for(const Box& box) {
  Lattice lattice;
  if (box.empty()) return lattice;
  const double magnitude = box.largest_magnitude();
  double reach = largest(half_extent(box));
  if (reach <= magnitude * 0x1p-40) reach = magnitude > 0 ? magnitude * 0x1p-20 : 1;
  // The origin is the box centre rounded to a multiple of 2^step pitches; that moves the box by at most 2^(step-1)
  // pitches. Where the reach is 2^-40 of the magnitude, half a unit in the last place of the centre is 2^9 pitches
  // more.
  constexpr int kOriginStep = 20;
  constexpr double kReachInPitches = kLatticeLimit - (1 << (kOriginStep - 1)) - (1 << 10);
  lattice.pitch = std::ldexp(1.0, std::ilogb(reach / kReachInPitches));
  while (lattice.pitch * kReachInPitches < reach) lattice.pitch *= 2;
  lattice.pitch = std::max(lattice.pitch, std::numeric_limits<double>::min());
  const double step = std::ldexp(lattice.pitch, kOriginStep);
  const dvec3 centre = box.low * 0.5 + box.high * 0.5;
  lattice.origin = {nearest_multiple(centre.x, step), nearest_multiple(centre.y, step),
                    nearest_multiple(centre.z, step)};
  return lattice;
}

bool holds(const Lattice& lattice, const Box& box) {
  int exponent = 0;
  if (box.empty() || !std::isnormal(lattice.pitch) || std::frexp(lattice.pitch, &exponent) != 0.5) return false;
  for (const dvec3& corner : {box.low, box.high}) {
    const dvec3 scaled = (corner - lattice.origin) / lattice.pitch;
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(lattice.origin[axis]) || !(std::abs(scaled[axis]) < kLatticeLimit - 0.5)) return false;
    }
  }
  return true;
}

}  // namespace rad::geom
