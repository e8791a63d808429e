// Which pieces of the soup are in the complex. The others are left as they are: triangles that nothing is wrong with.
// As soon as an edge or a point of one changes, it becomes part of the complex too, so that no crack opens.
#pragma once

#include <tsl/robin_map.h>

#include <span>
#include <vector>

#include "repair/complex.h"
#include "repair/leader_planes.h"
#include "repair/soup.h"
#include "repair/triangulation.h"

namespace rad::repair {

class PieceLoader {
 public:
  /// Gives the complex all points and pieces of the soup. `triangulation` holds the pieces that have three edges as
  /// they are, in their order; those `taken` are taken out. All three are kept by reference.
  PieceLoader(const Soup& soup, std::span<const std::uint8_t> taken, Complex& complex, Triangulation& triangulation);

  /// Puts pieces that were taken out into the complex. `part` holds them in the order of `pieces`, on the points of the
  /// complex; `claims` are the planes of `part`.
  void load(const Soup& part, std::span<const PieceId> pieces, const PlaneClaims& claims);
  /// Puts a piece that was left as it is into the complex: into the plane of a neighbour that it fits, or one of its
  /// own. False where it is there already.
  bool load(PieceId piece);
  /// Puts in the pieces of which an edge was split or a point merged since the last call. True where there were any.
  bool follow_changes();

 private:
  [[nodiscard]] bool as_it_is(PieceId piece) const { return triangle_of_[piece] != kNoTriangle; }
  [[nodiscard]] std::span<const PieceId> pieces_of(PointId point) const;
  [[nodiscard]] PointId now_at(PointId point) const;
  [[nodiscard]] ClusterId home_of(PieceId piece);
  [[nodiscard]] bool fits(PieceId piece, ClusterId cluster) const;
  void index_points();
  void trace(PointId from, PointId to, Item item, int depth);

  static constexpr std::uint32_t kNoTriangle = 0xffffffffu;

  const Soup& soup_;
  Complex& complex_;
  Triangulation& triangulation_;
  std::vector<std::uint32_t> triangle_of_;  ///< per piece: its triangle while it is as it is
  std::vector<std::uint32_t> first_use_;    ///< per point, of uses_
  std::vector<PieceId> uses_;               ///< triangular pieces by point
  tsl::robin_map<EdgeKey, PointId, EdgeKeyHash> split_at_;
  tsl::robin_map<PointId, PointId> merged_into_;
  std::size_t splits_seen_ = 0;
  std::size_t merges_seen_ = 0;
};

}  // namespace rad::repair
