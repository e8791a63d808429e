// Pairs of faces that the Grouper would merge into one maximal planar face.
#pragma once

#include <vector>

#include "validate/context.h"
#include "validate/rule.h"

namespace rad::validate {

/// Whether the two faces are of one object and material, look the same way and lie within T of the larger one's plane.
bool coplanar_within_tolerance(const Context& context, FaceId a, FaceId b);

/// Whether a third face meets one of the two faces on the subedge: its outline has to stay where it is.
bool contact_on_subedge(const Context& context, const Subedge& subedge, FaceId a, FaceId b);

/// An edge that two such faces share and that nothing else needs.
struct PlanarSeam {
  const Subedge* subedge = nullptr;
  FaceId a = 0;
  FaceId b = 0;
  bool keeps_texture = false;  ///< their texture coordinates are not of one affine map: merging would lose them
};

/// All seams, in the order of the topology's subedges.
std::vector<PlanarSeam> planar_seams(const Context& context);

/// Reports the seams that do, or do not, keep texture coordinates apart; the measure is the length.
void report_seams(const Context& context, bool keeping_texture, Violations& out);

}  // namespace rad::validate
