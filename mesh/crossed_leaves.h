// The leaves of an element mesh that lines of shadow cross.
#pragma once

#include <span>
#include <vector>

#include "mesh/shadow_lines.h"

namespace rad::mesh {

/// Sets `marked[leaf]` to 1, one entry per element, for every leaf that comes within `reach` pitches of a line on its
/// face. Goes from patch to patch across the edges of the face, from both ends of a line.
void mark_crossed(const ElementMesh& mesh, std::span<const ShadowLine> lines, double reach,
                  std::vector<std::uint8_t>& marked);

/// The same for leaves at contact edges, where more than two patches meet: radiosity jumps there.
void mark_at_contacts(const ElementMesh& mesh, std::vector<std::uint8_t>& marked);

}  // namespace rad::mesh
