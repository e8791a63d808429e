// The patches of one face (paper 3.4.1): boxes of the grid, and the triangulated remainder.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/face_frame.h"
#include "mesh/face_outline.h"
#include "mesh/sharp_edges.h"

namespace rad::mesh {

/// Corners of a triangle or strictly convex quadrilateral, counter-clockwise seen from the front.
struct PatchCorners {
  std::array<std::uint32_t, 4> point{};
  std::uint32_t count = 3;
};

/// Corner k is a point of the outline where k is below its number of ids, else point k - that number of `added`.
struct FacePatches {
  std::vector<geom::LatticePoint> added;
  std::vector<PatchCorners> patches;  ///< empty where the outline crosses itself
};

/// How the inside of faces is divided: the paper's even grid, or with patches that grow gradually from a finely divided
/// outline.
enum class PatchMethod : std::uint8_t { Graded, Grid };

/// In pitches.
struct FaceLengths {
  double longest = 0;          ///< edge that a patch may have
  double spacing = 0;          ///< least distance of points that meshing adds
  std::int64_t tolerance = 1;  ///< T
  PatchMethod method = PatchMethod::Grid;
};

/// `points` are those of the EdgeDivision that the outline refers to; those added leave out `zone`.
FacePatches face_patches(FaceFrame frame, const FaceOutline& outline, std::span<const geom::LatticePoint> points,
                         const FaceLengths& lengths, const ClearZone& zone);

/// Number of boxes of the grid over the face's bounding rectangle, about: what face_patches has to look at.
double grid_size(FaceFrame frame, const FaceOutline& outline, std::span<const geom::LatticePoint> points,
                 const FaceLengths& lengths);

}  // namespace rad::mesh
