// The lint of what will be written: the triangles, diagonals included. Repair ends when it is empty.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "repair/triangulation.h"

namespace rad::repair {

/// In the order in which the residual loop cures them.
enum class ViolationKind : std::uint8_t {
  Intersection,  ///< two triangles meet elsewhere than in common corners and edges: exact
  NearCoplanar,  ///< the middle of one is within T of the inside of another that faces the same way
  PointOnEdge,   ///< a point is within T of the inside of an edge, or all of a triangle is within T of its longest
  Contact,       ///< two triangles come within T of each other where they have no common point
};

struct Violation {
  ViolationKind kind = ViolationKind::Intersection;
  std::uint32_t a = 0;  ///< triangle; of a PointOnEdge the one that has the edge
  std::uint32_t b = 0;  ///< triangle; of a PointOnEdge the edge: from corner b to corner b+1
  PointId point = 0;    ///< of a PointOnEdge

  friend constexpr auto operator<=>(const Violation&, const Violation&) = default;
};

/// What is linted.
struct TriangleSet {
  std::span<const LatticePoint> points;
  std::span<const Triangle> triangles;
  std::span<const bool> folded;  ///< per cluster: its plane map folds over itself; empty where none does
};

/// All violations, ascending. `tolerance` is T in pitches. Legal: two triangles that lie on each other within T and
/// look opposite ways (a box on a floor). Points near edges are not legal even there: the display must be ziplocked.
std::vector<Violation> lint_triangles(const TriangleSet& set, std::int64_t tolerance);

}  // namespace rad::repair
