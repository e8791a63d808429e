// Points that make badly shaped triangles of a face better: Delaunay refinement that leaves the outline as it is, so
// that triangles grow gradually from a finely divided outline to the patch length.
#pragma once

#include <vector>

#include "mesh/face_patches.h"
#include "mesh/quad_pairing.h"
#include "mesh/spaced_points.h"

namespace rad::mesh {

/// Below this scaled ρ (where patches are graded), or below the least height, a triangle is to be bettered.
inline constexpr double kLeastShape = 0.45;

/// Where no point is to be added: near `spoiled`, and in the zone.
struct ShapeObstacles {
  const SpacedPoints& spoiled;
  const ClearZone& zone;
};

/// Points for the worst triangles: off-centres (on the bisector of the shortest edge, no farther than the
/// circumcentre), inside the face, clear of fixed edges and of each other. Triangles whose smallest angle is the face's
/// own get none. `least_height` in pitches.
std::vector<geom::LatticePoint> shape_points(std::span<const LinkedTriangle> triangles, const FacePoints& points,
                                             const FaceFrame& frame, const FaceLengths& lengths, double least_height,
                                             const ShapeObstacles& obstacles);

}  // namespace rad::mesh
