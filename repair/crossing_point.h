// The point that an edge and a plane get in common where the edge passes through the plane.
#pragma once

#include "repair/complex.h"

namespace rad::repair {

/// At a small angle the place of a crossing says little: far along the edge a point is still within T of edge and
/// plane. So where there is a point in use within T of the edge and T/2 of the plane, no farther along than that, it is
/// taken: planes that meet in a bundle of lines within T of one axis get one line in common, not as many as there are
/// pairs. Otherwise the point in use nearest to `place` within `reach` pitches, or a new one.
PointId crossing_point(Complex& complex, EdgeKey edge, const Plane& plane, const dvec3& place, double reach);

}  // namespace rad::repair
