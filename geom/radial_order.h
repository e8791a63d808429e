// The order in which half-planes follow each other around an edge: signs of determinants, no angles.
#pragma once

#include "geom/predicates.h"

namespace rad::geom {

/// Half-planes that are bounded by the line from `from` to `to`, each named by a lattice point in it that is not on the
/// line. They are ordered counter-clockwise as seen with the edge coming towards the viewer, from the one of
/// `reference` on. Exact: determinants stay below 2^77, and squared cosines below 2^104.
class RadialOrder {
 public:
  RadialOrder(const LatticePoint& from, const LatticePoint& to, const LatticePoint& reference)
      : from_(from), along_(difference(to, from)), reference_(difference(reference, from)) {}

  /// Whether the half-plane of `a` comes before that of `b`: a strict weak order.
  [[nodiscard]] bool precedes(const LatticePoint& a, const LatticePoint& b) const;
  /// Whether both name the same half-plane.
  [[nodiscard]] bool coincide(const LatticePoint& a, const LatticePoint& b) const {
    return !precedes(a, b) && !precedes(b, a);
  }

 private:
  /// The turn from the reference: none, less than half, half, more than half.
  enum class Turn : std::uint8_t { None, FirstHalf, Half, SecondHalf };

  [[nodiscard]] Sign determinant(const IntVector& a, const IntVector& b) const {
    return sign_of(dot(along_, cross(a, b)));
  }
  [[nodiscard]] bool on_reference_side(const IntVector& v) const;
  [[nodiscard]] Turn turn_to(const IntVector& v) const;

  LatticePoint from_;
  IntVector along_;
  IntVector reference_;
};

}  // namespace rad::geom
