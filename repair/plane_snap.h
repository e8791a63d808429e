// Plane snapping: once, each point moves into the leader planes that it belongs to, so that what lies within T of one
// plane lies in it.
#pragma once

#include "repair/leader_planes.h"

namespace rad::repair {

/// A point this far off a plane, as a share of T, is not in it yet.
inline constexpr double kSnapBandShare = 0.25;
/// A point moves at most this far, in T.
inline constexpr double kSnapBudget = 2;

struct SnapCounts {
  std::size_t moved = 0;
  double largest = 0;  ///< pitches
};

/// Moves every point that lies more than kSnapBandShare · T off one of its planes to the lattice point nearest to the
/// intersection of up to three of them, larger planes first. Its planes are those of the pieces that use it and of the
/// triangles that it comes within T of. `movable`: per point; empty where all are.
SnapCounts snap_to_planes(Soup& soup, const PlaneClaims& claims, double tolerance,
                          std::span<const std::uint8_t> movable = {});

}  // namespace rad::repair
