// Which triangles use which edge.
#pragma once

#include <span>
#include <vector>

#include "repair/maximal_faces.h"

namespace rad::repair {

/// A side of a triangle: 3 i + k is the one from corner k of triangle i to the next corner.
using Side = std::uint32_t;

/// The sides of a set of triangles by the edge that they lie on. Edges are numbered in the order of their ends, the
/// lesser end first; the sides on an edge ascend.
class EdgeUses {
 public:
  explicit EdgeUses(const PlanarTriangles& set);

  [[nodiscard]] std::uint32_t edge_count() const { return static_cast<std::uint32_t>(greater_end_.size()); }
  [[nodiscard]] std::span<const Side> on_edge(std::uint32_t edge) const {
    return std::span(sides_).subspan(first_side_[edge], first_side_[edge + 1] - first_side_[edge]);
  }
  /// The sides between two points; empty where there are none.
  [[nodiscard]] std::span<const Side> between(PointId a, PointId b) const;

 private:
  std::vector<std::uint32_t> first_edge_;  ///< per point: of those that it is the lesser end of
  std::vector<PointId> greater_end_;       ///< per edge
  std::vector<std::uint32_t> first_side_;  ///< per edge, with the end of the last
  std::vector<Side> sides_;
};

}  // namespace rad::repair
