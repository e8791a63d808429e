// The outline of a planar face from its directed edges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "repair/point_grid.h"

namespace rad::repair {

/// Puts directed edges together to loops that visit each of their points once. Keeps its memory from face to face.
class OutlineLoops {
 public:
  /// Points are below `point_count`.
  explicit OutlineLoops(std::size_t point_count) : place_(point_count, kNowhere) {}

  /// Follows the outline from its least point, of several ways the one to the least point that is left; where the chain
  /// comes back to a point of its own, what lies between is a loop. As many edges must lead into every point as out of
  /// it. `edges` ascending. Each loop starts at its least point.
  [[nodiscard]] std::vector<std::vector<PointId>> of(std::span<const std::array<PointId, 2>> edges);

 private:
  static constexpr std::uint32_t kNowhere = 0xffffffffu;

  void start(std::span<const std::array<PointId, 2>> edges);
  void take_chain(std::uint32_t first, std::vector<std::vector<PointId>>& loops);
  void close_loop(PointId at, std::vector<std::vector<PointId>>& loops);
  [[nodiscard]] std::uint32_t group_of(PointId from) const;

  std::span<const std::array<PointId, 2>> edges_;
  std::vector<PointId> from_;        ///< points that edges leave, ascending
  std::vector<std::uint32_t> next_;  ///< per such point: its first edge that is left
  std::vector<std::uint32_t> end_;   ///< and the end of its edges
  std::vector<PointId> chain_;
  std::vector<std::uint32_t> place_;  ///< per point: in the chain
};

}  // namespace rad::repair
