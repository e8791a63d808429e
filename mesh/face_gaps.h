// Where the outline of a face comes near to itself.
#pragma once

#include <vector>

#include "mesh/edge_division.h"
#include "mesh/face_outline.h"
#include "mesh/patch_sectors.h"

namespace rad::mesh {

struct FaceGaps {
  /// The length that patches are to have at a point of the division, pitches.
  struct Near {
    PointId point;
    double size;
  };
  std::vector<Near> near;
  std::vector<PointPair> across;  ///< points of the outline that see each other through the face
};

/// Looks at the Delaunay triangles between the points of the divided outline: a triangle at an edge tells how far the
/// next edge is. Edges that meet in a point do not count: between them patches narrow by nature.
FaceGaps face_gaps(const scene::ConformingModel& model, const scene::ConformingFace& face, const FaceOutline& outline,
                   const EdgeDivision& division);

}  // namespace rad::mesh
