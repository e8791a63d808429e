// The cells into which the triangles of a conforming model divide the air: where one can go without passing through a
// triangle, one stays in one cell.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geom/predicates.h"
#include "scene/lattice_model.h"

namespace rad::validate {

using CellId = std::uint32_t;

/// The cell around everything.
inline constexpr CellId kOpenSpace = 0;

/// A triangle has two sides: 0, where its normal points, and 1.
struct AirCells {
  std::vector<std::array<CellId, 2>> cell_of_side;  ///< per triangle
  std::vector<geom::Int128> volume6;  ///< per cell: six times its volume in pitches³, exact; 0 for kOpenSpace

  [[nodiscard]] std::size_t size() const { return volume6.size(); }
};

/// The cells between triangles that have area and meet in common corners and edges only, none twice. The sides around
/// an edge are joined in radial order; shells that this leaves apart are nested by one ray each, counting parity. All
/// of it is exact. Cells are numbered by place, whatever the order of points and triangles and whichever way these
/// face. Nothing where two triangles lie on each other beside an edge. O(n log n) but for the rays.
std::optional<AirCells> find_air_cells(std::span<const geom::LatticePoint> points,
                                       std::span<const std::array<scene::PointId, 3>> triangles);

}  // namespace rad::validate
