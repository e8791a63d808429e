// Free points of a triangulation moved to where the triangles around them are better shaped.
#pragma once

#include "mesh/linked_triangles.h"
#include "mesh/quad_pairing.h"

namespace rad::mesh {

class FaceFrame;

/// One pass over the points for which `free` holds, in their order: each goes to the mean of the middles of its
/// triangles, weighted by area, where the worst of them becomes better, none lower than `least_height` (pitches) and no
/// edge longer than `longest`. Says whether any moved.
bool smooth(std::span<const LinkedTriangle> triangles, const std::vector<bool>& free, const FaceFrame& frame,
            double least_height, double longest, FacePoints& points);

}  // namespace rad::mesh
