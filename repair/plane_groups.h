// Which triangles of a conforming set lie in one plane: what maximal faces are made of.
#pragma once

#include "repair/maximal_faces.h"

namespace rad::repair {

/// Gives the members of the set their planes: over common edges, each held against the plane of the largest triangle
/// around (never against its neighbour). Members that have a cluster are taken where all corners are within T of it,
/// those without within T/2; `tolerance` is T in pitches. Sets planes, and cluster and along of every member. Depends
/// on the places of points only.
void group_by_planes(PlanarTriangles& set, double tolerance);

}  // namespace rad::repair
