// Fans of faces around vertices.
#pragma once

#include <vector>

#include "validate/context.h"
#include "validate/violation.h"

namespace rad::validate {

/// A vertex at which the faces of one object form more than one fan.
struct PinchedVertex {
  PointId vertex = 0;
  std::array<FaceId, 2> faces{kNoFace, kNoFace};  ///< of two fans, the first of each by Context::precedes
  std::uint32_t fans = 0;
};

/// By vertex, then by the faces named. A fan is a set of faces of one object that hang together over subedges which end
/// at the vertex. Parallel, linear in the subedges.
std::vector<PinchedVertex> find_pinched_vertices(const Context& context);

}  // namespace rad::validate
