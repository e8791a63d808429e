// Every plane cluster as triangles: one constrained Delaunay triangulation each, with what covers each triangle.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "repair/complex.h"

namespace rad::repair {

/// A triangle of the model: a cell of a cluster that pieces of one facing cover.
struct Triangle {
  std::array<PointId, 3> points{};  ///< counter-clockwise seen from its front
  ClusterId cluster = 0;
  bool along = true;        ///< its front looks where the cluster's normal points
  PieceId winner = 0;       ///< the piece whose surface is visible here
  std::uint32_t cover = 0;  ///< of Triangulation::covers of its cluster: the pieces of both facings

  [[nodiscard]] bool has(PointId id) const { return points[0] == id || points[1] == id || points[2] == id; }
};

/// Where a cluster's projection is not a plane map: to be cured by merging and splitting.
struct Stacking {
  std::vector<std::array<PointId, 2>> points;                ///< different points, one place
  std::vector<std::pair<EdgeKey, PointId>> points_on_edges;  ///< a point over the inside of an edge
  bool crossing = false;                                     ///< edges that cross
};

class Triangulation {
 public:
  /// Brings the triangles up to date: triangulates anew the clusters that changed, in parallel.
  void update(const Complex& complex);

  /// All triangles, by cluster; where clusters have a triangle in common, the one of the smaller cluster.
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Pieces that cover a triangle, ascending.
  [[nodiscard]] const std::vector<PieceId>& cover_of(const Triangle& triangle) const {
    return clusters_[triangle.cluster].covers[triangle.cover];
  }
  [[nodiscard]] const Stacking& stacking() const { return stacking_; }
  [[nodiscard]] bool sound() const {
    return stacking_.points.empty() && stacking_.points_on_edges.empty() && !stacking_.crossing;
  }
  /// Per cluster: its plane map folds over itself.
  [[nodiscard]] std::span<const bool> folded() const { return {folded_.get(), clusters_.size()}; }

 private:
  struct ClusterPart {
    std::uint64_t version = 0;
    bool sound = true;
    std::vector<Triangle> triangles;
    std::vector<std::vector<PieceId>> covers;
    Stacking stacking;
  };

  static ClusterPart triangulate(const Complex& complex, ClusterId cluster);
  void drop_doubles(const Complex& complex);

  std::vector<ClusterPart> clusters_;
  std::unique_ptr<bool[]> folded_;
  std::vector<Triangle> triangles_;
  Stacking stacking_;
};

}  // namespace rad::repair
