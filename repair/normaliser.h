// Insert-only normalisation: T-vertices go into edges, edges that cross in the plane of a cluster get a common point.
// Points never move. Each split shortens, so the loop ends by itself in the plane; the caps are for what happens
// between planes (algorithm dossier B and D′). Only what is new since the last run is looked at.
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
  /// The edges of a cluster in its projection, as far as they were looked at.
  struct FlatEdges {
    geom::GrowingBoxTree tree;  ///< items are places in Cluster::added
    std::size_t searched = 0;   ///< of Cluster::added: in the tree
    std::size_t uncrossed = 0;  ///< of Cluster::added: known not to cross any that was there
  };

  bool insert_points_on_edges();
  [[nodiscard]] std::vector<EdgeKey> edges_to_search();
  bool cut_crossings(double reach);
  [[nodiscard]] std::vector<std::array<EdgeKey, 2>> new_crossings(ClusterId cluster);
  bool cut_crossings_in(ClusterId cluster, double reach);

  Complex& complex_;
  std::size_t edges_seen_ = 0;    ///< of Complex::edges_added
  std::size_t points_seen_ = 0;   ///< of Complex::points_revived
  std::vector<EdgeKey> put_off_;  ///< edges that points could not be put into when they were found
  std::vector<FlatEdges> flat_;   ///< per cluster
};

/// Splits the edge at the point where both halves get shorter; otherwise merges the point with the nearer end.
void split_or_merge(Complex& complex, EdgeKey edge, PointId point);

}  // namespace rad::repair
