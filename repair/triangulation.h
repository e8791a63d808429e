// Every plane cluster as triangles: one constrained Delaunay triangulation each, with what covers each triangle; and
// the triangles that nothing is wrong with, as they are.
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geom/growing_box_tree.h"
#include "repair/complex.h"

namespace rad::repair {

/// A triangle of the model: a cell of a cluster that pieces of one facing cover, or a piece as it is.
struct Triangle {
  std::array<PointId, 3> points{};  ///< counter-clockwise seen from its front; the smallest id first
  ClusterId cluster = kNoCluster;   ///< none for a piece as it is
  bool along = true;                ///< its front looks where the cluster's normal points
  PieceId winner = 0;               ///< the piece whose surface is visible here
  std::uint32_t cover = 0;          ///< of its cluster: the pieces of both facings

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
  /// Adds a piece as it is, a triangle of its own until its cluster is triangulated; the triangle's number.
  std::uint32_t add_as_it_is(std::array<PointId, 3> points, PieceId piece);
  /// Takes such a triangle out: its piece is part of the complex from now on.
  void remove_as_it_is(std::uint32_t triangle);

  /// Brings the triangles up to date: triangulates anew the clusters that changed, in parallel. A triangle that is in
  /// the map before and after keeps its number.
  void update(const Complex& complex);

  /// By number, those that are gone too.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// Per triangle: it is there. Where clusters have a triangle in common only the one of the larger cluster is.
  [[nodiscard]] std::span<const std::uint8_t> alive() const { return alive_; }
  /// Whether it is there or hidden by one of a larger cluster.
  [[nodiscard]] bool exists(std::uint32_t triangle) const { return exists_[triangle] != 0; }
  /// The numbers of a cluster's triangles, in the order of its map; hidden ones too.
  [[nodiscard]] std::span<const std::uint32_t> of_cluster(ClusterId cluster) const {
    return cluster < clusters_.size() ? std::span<const std::uint32_t>(clusters_[cluster].triangles)
                                      : std::span<const std::uint32_t>();
  }
  /// The numbers of all triangles that are there: by cluster, then those as they are.
  [[nodiscard]] std::vector<std::uint32_t> living() const;
  /// Triangles that came alive since the last call, or lie in a map that folds; each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> take_fresh();

  /// Pieces that cover a triangle of a cluster, ascending.
  [[nodiscard]] const std::vector<PieceId>& cover_of(const Triangle& triangle) const {
    return clusters_[triangle.cluster].covers[triangle.cover];
  }
  /// Whether pieces of the same facing lie under the winner.
  [[nodiscard]] bool hides_others(const Complex& complex, const Triangle& triangle) const;
  [[nodiscard]] const Stacking& stacking() const { return stacking_; }
  [[nodiscard]] bool sound() const {
    return stacking_.points.empty() && stacking_.points_on_edges.empty() && !stacking_.crossing;
  }
  /// Per cluster: its plane map folds over itself.
  [[nodiscard]] std::span<const std::uint8_t> folded() const { return folded_; }

 private:
  struct ClusterPart {
    std::uint64_t version = 0;
    std::vector<std::uint32_t> triangles;
    std::vector<std::vector<PieceId>> covers;
    Stacking stacking;

    [[nodiscard]] bool sound() const {
      return stacking.points.empty() && stacking.points_on_edges.empty() && !stacking.crossing;
    }
  };
  struct Map {
    ClusterPart part;
    std::vector<Triangle> triangles;
  };
  struct PointsHash {
    std::size_t operator()(const std::array<PointId, 3>& points) const {
      std::uint64_t hash = points[0];
      for (const PointId id : {points[1], points[2]}) hash = (hash ^ (hash >> 29)) * 0x9e3779b97f4a7c15u + id;
      return static_cast<std::size_t>(hash ^ (hash >> 32));
    }
  };

  static Map triangulate(const Complex& complex, ClusterId cluster);
  void take_over(const Complex& complex, ClusterId cluster, Map map);
  std::uint32_t add(const Triangle& triangle);
  void choose(const Complex& complex, std::uint32_t any_of_them);
  void enter(const Complex& complex, std::uint32_t triangle);
  void leave(const Complex& complex, std::uint32_t triangle);
  void set_alive(std::uint32_t triangle, bool alive);

  std::vector<ClusterPart> clusters_;
  std::vector<std::uint8_t> folded_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> alive_;
  std::vector<std::uint8_t> exists_;
  std::vector<std::uint32_t> as_they_are_;
  std::vector<std::uint32_t> fresh_;
  tsl::robin_map<std::array<PointId, 3>, std::uint32_t, PointsHash> first_of_;  ///< of those with the same points
  std::vector<std::uint32_t> next_same_;                                        ///< per triangle
  Stacking stacking_;
};

}  // namespace rad::repair
