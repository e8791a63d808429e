// A ray from the inside of a triangle along an axis, and which other triangles it passes through: exact.
#pragma once

#include <array>

#include "geom/box_tree.h"
#include "geom/lattice.h"
#include "geom/predicates.h"

namespace rad::validate {

/// Starts at the middle of a triangle with area and runs along the axis that its normal is nearest to, away from one
/// of its sides. Where it would meet an edge or a corner it is taken to pass beside it, by an infinitely small step
/// across (a smaller one along the second axis), so that every question has an answer and the answers agree.
class InteriorRay {
 public:
  /// `in_front`: away from the side where the normal points.
  InteriorRay(const std::array<geom::LatticePoint, 3>& triangle, bool in_front);

  /// Holds the whole ray, up to the end of the lattice.
  [[nodiscard]] geom::LatticeBox box() const;

  /// Whether it passes through a triangle with area. The start must not be on it.
  [[nodiscard]] bool passes(const std::array<geom::LatticePoint, 3>& triangle) const;

 private:
  [[nodiscard]] bool passes_in_projection(const std::array<geom::LatticePoint, 3>& triangle) const;

  std::array<std::int64_t, 3> start_{};  ///< three times the middle
  int axis_ = 0;
  bool upward_ = true;
};

}  // namespace rad::validate
