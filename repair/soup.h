// The faces of a model as pieces that are nearly planar, on welded points: what the Grouper groups.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "repair/point_grid.h"
#include "scene/scene.h"

namespace rad::repair {

/// A triangle of a face, or a whole face whose rings cross: its edges as directed pairs of points.
struct SoupPiece {
  std::uint32_t first_edge = 0;
  std::uint32_t edge_count = 3;
  scene::FaceId source = 0;
  std::uint32_t rank = 0;              ///< of its surface: the least wins where surfaces overlap
  bool won = false;                    ///< others lay in it and gave way
  std::uint32_t origin = 0xffffffffu;  ///< of Soup::origins
};

struct Soup {
  std::vector<LatticePoint> points;
  std::vector<std::array<PointId, 2>> edges;
  std::vector<SoupPiece> pieces;
  std::vector<std::array<LatticePoint, 3>> origins;  ///< where pieces were before anything was done

  [[nodiscard]] std::span<const std::array<PointId, 2>> edges_of(const SoupPiece& piece) const {
    return std::span(edges).subspan(piece.first_edge, piece.edge_count);
  }
  /// Of a triangle twice its area times the unit normal, pitches²; zero where it has collapsed. Of rings that cross,
  /// whose parts may cancel, the same of the largest triangle that two of their edges in a row span.
  [[nodiscard]] dvec3 normal_of(const SoupPiece& piece) const;
  /// The corners of a triangle piece.
  [[nodiscard]] std::array<LatticePoint, 3> triangle(const SoupPiece& piece) const;
  /// Notes where its triangles are now.
  void note_origins();

 private:
  [[nodiscard]] dvec3 newell_normal(const SoupPiece& piece) const;
  [[nodiscard]] dvec3 normal_of_crossing_rings(const SoupPiece& piece) const;
};

/// The pieces named, in that order, on all the points.
Soup part_of(const Soup& soup, std::span<const std::uint32_t> pieces);

/// Lets `representative[i]` take the place of point i, then drops edges without length and pieces without area. Returns
/// the pieces dropped.
std::size_t replace_points(Soup& soup, std::span<const std::uint32_t> representative);

}  // namespace rad::repair
