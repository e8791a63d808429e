// Pairs of triangles made well-shaped quadrilaterals.
#pragma once

#include <span>
#include <vector>

#include "mesh/linked_triangles.h"

namespace rad::mesh {

/// The points of a face: in projection, in its plane, and on the lattice.
struct FacePoints {
  std::vector<geom::LatticePoint> lattice;
  std::vector<geom::PlanarPoint> flat;
  std::vector<geom::PlanePoint> plane;
};

/// What a pair must keep.
struct PairingLimits {
  double longest = 0;         ///< pitches: a longer common edge makes pairing worth more
  std::int64_t flatness = 1;  ///< pitches: how far the fourth corner may lie off the plane of the others
};

/// A corner above this makes a quadrilateral no better than two triangles.
inline constexpr double kWidestQuadCorner = 140;  ///< degrees

/// For every triangle the one that it is to form a quadrilateral with, or kNoTriangle: best shapes first, where the
/// quadrilateral is strictly convex (exactly, in projection), flat, and no worse shaped than two triangles.
std::vector<std::uint32_t> quad_partners(std::span<const LinkedTriangle> triangles, const FacePoints& points,
                                         const PairingLimits& limits);

/// Corners of the quadrilateral of a triangle and its neighbour over `edge`, counter-clockwise.
std::array<std::uint32_t, 4> quad_over(std::span<const LinkedTriangle> triangles, std::uint32_t triangle,
                                       std::size_t edge);

}  // namespace rad::mesh
