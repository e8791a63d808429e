// Which faces have to agree on the way they look: those that continue each other across an edge (1b).
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "validate/context.h"

namespace rad::validate {

/// Whether two faces have the same corners.
bool have_the_same_corners(const Context& context, FaceId a, FaceId b);

/// The pairs of coedges that neighbours have on the subedge; they agree where one runs forward and the other backward.
/// Neighbours are the two faces of a subedge that has no others; of more, the two that are of one object; of four of
/// one named object, of which two lie on each other (touching solids), those two and the other two. Nothing else is
/// decided across an edge where more than two faces meet.
std::vector<std::array<Coedge, 2>> neighbours_at(const Context& context, const Subedge& subedge);

/// Calls visit(a, b) for the pairs of neighbours_at. Most subedges have two coedges: for them nothing is allocated.
template <typename Visit>
void for_each_neighbours(const Context& context, const Subedge& subedge, Visit&& visit) {
  const auto coedges = context.topology.coedges_of(subedge);
  if (coedges.size() == 2) {
    if (coedges[0].face != coedges[1].face) visit(coedges[0], coedges[1]);
  } else if (coedges.size() > 2) {
    for (const auto& pair : neighbours_at(context, subedge)) visit(pair[0], pair[1]);
  }
}

}  // namespace rad::validate
