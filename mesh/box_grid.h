// The rectangular grid over a face (paper 3.4.1, Figures 5 and 6): its corners well inside, and its boxes wholly
// inside.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geom/constrained_triangulation.h"
#include "geom/planar_shape.h"

namespace rad::mesh {

/// Grid lines at low + k·step. Lengths in pitches, in the frame of the face's plane.
struct GridLines {
  geom::PlanePoint low;
  std::array<double, 2> step{1, 1};
  std::array<std::uint32_t, 2> boxes{1, 1};  ///< columns, rows

  [[nodiscard]] geom::PlanePoint corner(std::uint32_t column, std::uint32_t row) const {
    return {low.x + step[0] * column, low.y + step[1] * row};
  }
};

/// What the grid must keep away from: the divided outline and inner edges, and single points, by index into `points`.
struct GridObstacles {
  /// A segment that corners keep `clearance` from, however fine the grid.
  struct Sharp {
    geom::PlanePoint from, to;
    double clearance = 0;
  };
  std::span<const geom::PlanePoint> points;
  std::span<const geom::PointEdge> outline;
  std::span<const geom::PointEdge> inner;
  std::span<const std::uint32_t> single;
  std::span<const Sharp> sharp;
};

/// A corner is near the boundary, and its boxes are outside (Figure 6), below this share of the smaller grid step.
inline constexpr double kNearShare = 0.6;

struct BoxGrid {
  std::vector<geom::PlanePoint> corners;            ///< inside the face and not near its edges; by row
  std::vector<std::array<std::uint32_t, 4>> boxes;  ///< indices of corners, counter-clockwise; no edge runs through
};

BoxGrid box_grid(const GridLines& lines, const GridObstacles& obstacles);

}  // namespace rad::mesh
