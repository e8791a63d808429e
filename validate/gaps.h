// Vertices that come near to another component without touching it: gaps through which light leaks.
#pragma once

#include <vector>

#include "validate/context.h"
#include "validate/violation.h"

namespace rad::validate {

/// Between a vertex of one component and the place of another that is nearest to it: more than T apart.
struct ComponentGap {
  PointId vertex = 0;
  FaceId vertex_face = kNoFace;  ///< of those at the vertex, the first by Context::precedes
  FaceId face = kNoFace;         ///< of the other component
  dvec3 foot{};                  ///< lattice units, on that face
  double width = 0;              ///< pitches
  double cosine = 0;             ///< between the normals of the two faces
};

/// By vertex; for each vertex of the components `of` that touches no other component one for every component within
/// `reach` pitches. Looks only where the box of another component comes that near, on the tree of the contact search.
/// Parallel.
std::vector<ComponentGap> find_gaps(const Context& context, double reach, const std::vector<bool>& of);

/// Per component whether it is an open sheet in one plane.
std::vector<bool> open_flat_sheets(const Context& context);

/// The sheets that are decals by these gaps: as a whole over others and parallel to them.
std::vector<bool> decals_among(const Context& context, const std::vector<bool>& sheets,
                               const std::vector<ComponentGap>& gaps);

/// The gaps of edges: both ends are near to the same component, and nearer than the edge is long. A vertex that is near
/// alone comes near by chance.
std::vector<ComponentGap> gaps_of_edges(const Context& context, const std::vector<ComponentGap>& gaps);

/// Gaps up to this many T are looked for where nothing is configured.
inline constexpr double kGapTolerances = 20;

}  // namespace rad::validate
