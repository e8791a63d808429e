// Insert-only normalisation: T-vertices go into edges, edges that cross in the plane of a cluster get a common point.
// Points never move. Each split shortens, so the loop ends by itself in the plane; the caps are for what happens
// between planes (algorithm dossier B and D′).
#pragma once

#include <vector>

#include "repair/complex.h"

namespace rad::repair {

class Normaliser {
 public:
  explicit Normaliser(Complex& complex) : complex_(complex) {}

  /// Repeats both passes until neither finds anything. True where something changed. `reach`: crossings use a point
  /// within this distance, pitches.
  bool run(double reach);

 private:
  bool insert_points_on_edges();
  bool cut_crossings(double reach);
  bool cut_crossings_in(ClusterId cluster, double reach);

  Complex& complex_;
  std::vector<std::uint64_t> uncrossed_;  ///< per cluster: the version that was found without crossings
};

/// Splits the edge at the point where both halves get shorter; otherwise merges the point with the nearer end.
void split_or_merge(Complex& complex, EdgeKey edge, PointId point);

}  // namespace rad::repair
