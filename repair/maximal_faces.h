// Triangles of the complex put together to the largest planar faces, with holes and slits (paper 2.2, 1c).
#pragma once

#include <vector>

#include "repair/complex.h"
#include "scene/conforming_model.h"

namespace rad::repair {

/// Triangles that meet in whole edges and corners only, each in the plane of a cluster.
struct PlanarTriangles {
  struct Member {
    std::array<PointId, 3> points{};  ///< counter-clockwise seen from the front
    ClusterId cluster = 0;
    bool along = true;  ///< its front looks where the plane's normal points
    scene::FaceId source = 0;
    bool won = false;         ///< other pieces of its facing lay there and were removed
    std::uint32_t layer = 0;  ///< where overlaps are kept: how many triangles like this one lie over it
  };
  std::vector<LatticePoint> points;
  std::vector<Plane> planes;  ///< per cluster
  std::vector<Member> members;
};

/// Two triangles belong to one face where they share an edge, lie in one plane and layer, look one way and have
/// material, object and group in common, and nothing else ends at or touches that edge. `scene` holds the faces that `source` names.
/// Points are numbered in the order of space, faces stand in the order of their triangles, which are ordered by points.
scene::ConformingModel maximal_faces(const PlanarTriangles& triangles, const scene::Scene& scene,
                                     const geom::Lattice& lattice, const geom::Tolerance& tolerance);

}  // namespace rad::repair
