// What the boxes of the grid leave of a face: triangulated, long triangles divided, pairs made quadrilaterals.
#pragma once

#include <vector>

#include "mesh/face_patches.h"
#include "mesh/quad_pairing.h"

namespace rad::mesh {

/// A free point may be dropped where it would spoil the triangles; an unused one lies between boxes only.
enum class PointState : std::uint8_t { Fixed, Free, Unused };

struct Remainder {
  FacePoints points;
  std::vector<PointState> state;   ///< one for each point
  std::vector<PointEdge> outline;  ///< of the face and of the boxes
  std::vector<PointEdge> inner;
  std::uint32_t kept = 0;  ///< the first points, which belong to the outline of the face
};

void add_point(FacePoints& points, const FaceFrame& frame, const geom::LatticePoint& point);

/// Appends the patches and adds points where triangles are too long. False where the outline crosses itself.
bool mesh_remainder(Remainder& remainder, const FaceFrame& frame, const FaceLengths& lengths, const ClearZone& zone,
                    std::vector<PatchCorners>& patches);

}  // namespace rad::mesh
