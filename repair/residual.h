// The residual loop: cures what the lint of the triangles still finds, one kind a round, until it finds nothing
// (algorithm dossier D′).
#pragma once

#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "repair/complex.h"
#include "repair/triangle_lint.h"
#include "repair/triangle_search.h"
#include "repair/triangulation.h"

namespace rad::repair {

/// How hard a round tries. Each is taken where the one before changed nothing.
enum class Effort : std::uint8_t {
  OneKind,   ///< the first kind of violation that there is
  AllKinds,  ///< all kinds at once
  Forced,    ///< all kinds, with flips by force and wider re-homing
  Merge,     ///< merges the closest points of each violation
};

struct ResidualCounts {
  std::size_t rehomed = 0;
  std::size_t steiner_points = 0;
  std::size_t local_merges = 0;
};

class Residual {
 public:
  explicit Residual(Complex& complex) : complex_(complex), search_(complex) {}

  /// One round. `reach`: new points use a point within this distance, pitches. True where something changed.
  bool round(const Triangulation& triangulation, std::span<const Violation> violations, Effort effort, double reach);

  [[nodiscard]] const ResidualCounts& counts() const { return counts_; }

 private:
  struct Round;
  using TriangleKey = std::array<PointId, 3>;

  Complex& complex_;
  TriangleSearch search_;                                ///< brought up to date by those who ask it
  std::set<std::pair<ClusterId, EdgeKey>> imprinted_;    ///< tried once, never again
  std::set<std::pair<TriangleKey, ClusterId>> rehomed_;  ///< likewise
  std::set<PointId> steiner_;                            ///< free points of ours: dropped, never merged
  ResidualCounts counts_;
};

}  // namespace rad::repair
