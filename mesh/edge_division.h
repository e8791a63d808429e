// The division of the model's edges: a property of the edge, so that every face at it reads the same points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/sharp_edges.h"
#include "scene/conforming_model.h"

namespace rad::mesh {

using scene::PointId;

/// An edge of the model by its ends, the one with the smaller position first.
using EdgeKey = std::array<PointId, 2>;

class EdgeSizes;
struct SizedPlace;

class EdgeDivision {
 public:
  /// Divides every edge of a loop and every inner edge into parts of at most the smallest `longest_of_face` (pitches)
  /// of its faces: equal ones where `sizes` is empty, else as it asks. Edges in `halved` (ascending) into two at least,
  /// edges in `whole` (ascending) not at all. No point comes nearer than least_spacing() to another point or, at the
  /// ends, to another edge there, or than its clearance to a sharp edge of a face that both are of.
  EdgeDivision(const scene::ConformingModel& model, std::span<const double> longest_of_face,
               std::span<const EdgeKey> halved, std::span<const EdgeKey> whole, const EdgeSizes& sizes,
               std::span<const std::vector<SharpEdge>> sharp_of_face);

  /// The model's points, then those that divide edges.
  [[nodiscard]] const std::vector<geom::LatticePoint>& points() const { return points_; }

  /// Appends `from` and the points between it and `to`, which must be the ends of an edge.
  void append_chain(PointId from, PointId to, std::vector<PointId>& chain) const;

  // Edges are numbered by their ends, ascending: alike in every division of a model.
  [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }
  [[nodiscard]] const EdgeKey& ends(std::size_t edge) const { return edges_[edge].ends; }
  /// Pitches.
  [[nodiscard]] double longest(std::size_t edge) const { return edges_[edge].longest; }
  /// Both ends, and the points between them.
  void chain_of(std::size_t edge, std::vector<PointId>& chain) const;
  /// The edge that a point divides.
  [[nodiscard]] std::size_t edge_of(PointId point) const;

  [[nodiscard]] EdgeKey key(PointId a, PointId b) const {
    return points_[a] < points_[b] ? EdgeKey{a, b} : EdgeKey{b, a};
  }

 private:
  struct Edge {
    EdgeKey ends{};
    double longest = 0;
    std::array<double, 2> reach{};  ///< pitches from either end that stay undivided: the edges there are too near
    PointId first = 0;              ///< of its points, ascending from ends[0]
    std::uint32_t count = 0;
  };

  void collect(const scene::ConformingModel& model, std::span<const double> longest_of_face);
  void find_reaches(double spacing);
  void widen_reaches(const scene::ConformingModel& model, std::span<const std::vector<SharpEdge>> sharp_of_face);
  void widen_reach(const std::array<PointId, 2>& edge, PointId along, double clearance);
  [[nodiscard]] std::vector<double> places(const Edge& edge, std::span<const SizedPlace> sizes,
                                           std::uint32_t least_parts, double spacing) const;

  std::vector<geom::LatticePoint> points_;
  std::vector<Edge> edges_;  ///< ascending by ends
};

}  // namespace rad::mesh
