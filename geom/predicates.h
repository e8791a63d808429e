// Exact predicates on lattice points. Every answer is that of real arithmetic on the integers; nothing here rounds.
//
// Bit budget for |coordinate| < 2^23: differences 2^24, orient2d 2^49, normals 2^49 a component, orient3d and plane
// values 2^75, squared distances 2^50, squared normals 2^100, (n·v)² 2^151.
#pragma once

#include <array>
#include <cstdint>

#include "geom/vec.h"

namespace rad::geom {

__extension__ using Int128 = __int128;

enum class Sign : std::int8_t { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }

template <typename Number>
constexpr Sign sign_of(Number value) {
  return value > 0 ? Sign::Positive : value < 0 ? Sign::Negative : Sign::Zero;
}

/// A vector of exact differences or cross products of lattice points.
struct IntVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  friend constexpr bool operator==(const IntVector&, const IntVector&) = default;
};

constexpr IntVector difference(const LatticePoint& to, const LatticePoint& from) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y, std::int64_t{to.z} - from.z};
}

/// Components must be below 2^24 in magnitude.
constexpr IntVector cross(const IntVector& a, const IntVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr Int128 dot(const IntVector& a, const IntVector& b) {
  return Int128{a.x} * b.x + Int128{a.y} * b.y + Int128{a.z} * b.z;
}

/// Axis along which |n| is largest (ties: x before y before z): the one to drop when projecting a face.
int dominant_axis(const IntVector& normal);

/// Point with axis `dropped` left out, in the order that keeps orientation: seen from the positive end of that axis.
struct PlanarPoint {
  std::int64_t u = 0;
  std::int64_t v = 0;

  friend constexpr auto operator<=>(const PlanarPoint&, const PlanarPoint&) = default;
};
PlanarPoint project(const LatticePoint& point, int dropped);

/// Positive where a, b, c turn counter-clockwise. orient2d(a,b,c) = orient2d(b,c,a) = -orient2d(b,a,c).
Sign orient2d(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c);

/// Positive where d lies on the side of plane abc that its normal (b-a)×(c-a) points to; zero where coplanar.
/// Swapping any two points changes the sign.
Sign orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d);

bool collinear(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

std::int64_t squared_distance(const LatticePoint& a, const LatticePoint& b);

/// Whether the distance of two points is at most `tolerance` pitches.
bool points_within(const LatticePoint& a, const LatticePoint& b, std::int64_t tolerance);

/// Whether the distance from `point` to the closed segment is at most `tolerance` pitches.
bool point_within_segment(const LatticePoint& point, const LatticePoint& from, const LatticePoint& to,
                          std::int64_t tolerance);

/// Whether the foot of `point` on the line lies inside the segment, more than `margin` pitches from both ends.
bool foot_inside_segment(const LatticePoint& point, const LatticePoint& from, const LatticePoint& to,
                         std::int64_t margin);

/// The oriented plane through a lattice triangle; its normal is (b-a)×(c-a), zero for a triangle without area.
struct TrianglePlane {
  IntVector normal;
  LatticePoint through;
  double normal_length = 0;  ///< |normal|, rounded

  TrianglePlane() = default;
  TrianglePlane(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

  [[nodiscard]] bool has_area() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
  /// normal · (point - through): exact.
  [[nodiscard]] Int128 value(const LatticePoint& point) const { return dot(normal, difference(point, through)); }
  /// value / |normal|, in pitches, rounded.
  [[nodiscard]] double distance(const LatticePoint& point) const;
  /// The nearest point of the plane, rounded; `point` itself where it lies in the plane.
  [[nodiscard]] dvec3 foot(const LatticePoint& point) const;
};

/// Zero where `point` is at most `tolerance` pitches from the plane, else its side. Exact: (n·v)² against T²|n|².
Sign side_of_plane_within(const TrianglePlane& plane, const LatticePoint& point, std::int64_t tolerance);

}  // namespace rad::geom
