#include "geom/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>

namespace rad::geom {
namespace {

using Int256 = boost::multiprecision::int256_t;

Int256 widened(Int128 value) {
  const bool negative = value < 0;
  const auto magnitude = negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  Int256 wide = static_cast<std::uint64_t>(magnitude >> 64);
  wide <<= 64;
  wide += static_cast<std::uint64_t>(magnitude);
  return negative ? Int256(-wide) : wide;
}

}  // namespace

int dominant_axis(const IntVector& normal) {
  const std::int64_t x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

PlanarPoint project(const LatticePoint& point, int dropped) {
  if (dropped == 0) return {point.y, point.z};
  if (dropped == 1) return {point.z, point.x};
  return {point.x, point.y};
}

Sign orient2d(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return sign_of((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
}

Sign orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  return sign_of(dot(cross(difference(b, a), difference(c, a)), difference(d, a)));
}

bool collinear(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return cross(difference(b, a), difference(c, a)) == IntVector{};
}

std::int64_t squared_distance(const LatticePoint& a, const LatticePoint& b) {
  const IntVector d = difference(a, b);
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

bool points_within(const LatticePoint& a, const LatticePoint& b, std::int64_t tolerance) {
  return Int128{squared_distance(a, b)} <= Int128{tolerance} * tolerance;
}

bool point_within_segment(const LatticePoint& point, const LatticePoint& from, const LatticePoint& to,
                          std::int64_t tolerance) {
  const IntVector along = difference(to, from);
  const IntVector offset = difference(point, from);
  const Int128 reach = dot(along, offset);
  const Int128 squared_length = dot(along, along);
  if (reach <= 0) return points_within(point, from, tolerance);
  if (reach >= squared_length) return points_within(point, to, tolerance);
  const IntVector spread = cross(along, offset);
  return dot(spread, spread) <= Int128{tolerance} * tolerance * squared_length;
}

bool foot_inside_segment(const LatticePoint& point, const LatticePoint& from, const LatticePoint& to,
                         std::int64_t margin) {
  const IntVector along = difference(to, from);
  const Int128 squared_length = dot(along, along);
  const Int128 reach = dot(along, difference(point, from));
  const Int128 rest = squared_length - reach;
  const Int128 bound = Int128{margin} * margin * squared_length;
  return reach > 0 && rest > 0 && reach * reach > bound && rest * rest > bound;
}

TrianglePlane::TrianglePlane(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
    : normal(cross(difference(b, a), difference(c, a))), through(a) {
  normal_length = std::sqrt(static_cast<double>(dot(normal, normal)));
}

double TrianglePlane::distance(const LatticePoint& point) const {
  return static_cast<double>(value(point)) / normal_length;
}

dvec3 TrianglePlane::foot(const LatticePoint& point) const {
  const double share = static_cast<double>(value(point)) / (normal_length * normal_length);
  return {point.x - share * static_cast<double>(normal.x), point.y - share * static_cast<double>(normal.y),
          point.z - share * static_cast<double>(normal.z)};
}

Sign side_of_plane_within(const TrianglePlane& plane, const LatticePoint& point, std::int64_t tolerance) {
  const Int128 value = plane.value(point);
  // Each of value, |n| and their product is rounded a handful of times: 2^-50 relative covers them; 2^-40 is safe.
  constexpr double kSlack = 0x1p-40;
  const double magnitude = std::abs(static_cast<double>(value));
  const double band = static_cast<double>(tolerance) * plane.normal_length;
  if (magnitude < band * (1 - kSlack)) return Sign::Zero;
  if (magnitude > band * (1 + kSlack)) return sign_of(value);
  const Int256 wide = widened(value);
  const Int256 bound = widened(Int128{tolerance} * tolerance) * widened(dot(plane.normal, plane.normal));
  return wide * wide <= bound ? Sign::Zero : sign_of(value);
}

}  // namespace rad::geom
