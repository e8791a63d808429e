// Anchoring (paper 3.4.2, Figure 9): a leaf element split at the middles of its edges, so that none is a T-vertex.
#pragma once

#include <array>
#include <span>

#include "mesh/radiosity_mesh.h"

namespace rad::mesh {

inline constexpr NodeId kNoNode = 0xffffffffU;

/// Triangles and quadrilaterals that cover an element, counter-clockwise; one for an element without anchors.
struct AnchoredPieces {
  std::array<Corners, 5> piece{};
  std::uint32_t count = 0;

  [[nodiscard]] std::span<const Corners> all() const& { return std::span(piece).first(count); }
  void all() const&& = delete;  // would outlive its pieces
};

/// `middle[i]` is the node in the middle of the edge from corner i on, or kNoNode. Pieces use corners and middles only.
/// Besides the paper's six types, triangles with three and quadrilaterals with four: elements too small to be divided.
AnchoredPieces anchored_pieces(const Corners& corners, const std::array<NodeId, 4>& middle);

}  // namespace rad::mesh
