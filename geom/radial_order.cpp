#include "geom/radial_order.h"

namespace rad::geom {

bool RadialOrder::precedes(const LatticePoint& a, const LatticePoint& b) const {
  const IntVector to_a = difference(a, from_), to_b = difference(b, from_);
  const Turn turn_a = turn_to(to_a), turn_b = turn_to(to_b);
  if (turn_a != turn_b) return turn_a < turn_b;
  if (turn_a == Turn::None || turn_a == Turn::Half) return false;
  return determinant(to_a, to_b) == Sign::Positive;
}

// The dot product of what is left of both vectors across the edge, times its squared length.
bool RadialOrder::on_reference_side(const IntVector& v) const {
  return dot(reference_, v) * dot(along_, along_) > dot(reference_, along_) * dot(v, along_);
}

RadialOrder::Turn RadialOrder::turn_to(const IntVector& v) const {
  switch (determinant(reference_, v)) {
    case Sign::Positive:
      return Turn::FirstHalf;
    case Sign::Negative:
      return Turn::SecondHalf;
    case Sign::Zero:
      break;
  }
  return on_reference_side(v) ? Turn::None : Turn::Half;
}

}  // namespace rad::geom
