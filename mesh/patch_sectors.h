// Which patch corners at a point belong to one sector of a surface, and so to one node.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/face_patches.h"
#include "mesh/patch_mesh.h"

namespace rad::mesh {

/// Two points, the lower index first.
using PointPair = std::array<std::uint32_t, 2>;

/// Patches of all faces; corners are indices of points.
struct PatchSoup {
  std::vector<PatchCorners> corners;
  std::vector<std::uint32_t> face;  ///< of each patch
};

/// Surfaces have continuous normals (paper 2.1): across an edge they may turn by this much.
inline constexpr double kSmoothDegrees = 30;

struct Sectors {
  std::vector<std::array<std::uint32_t, 4>> node;  ///< of each corner of each patch
  std::uint32_t node_count = 0;
  /// Edges that separate two sides although both ends are one sector each: a division of the edge would part them.
  /// Ascending.
  std::vector<PointPair> unparted;
};

/// `contacts` are edges inside faces where another face touches, ascending: they separate.
Sectors find_sectors(const PatchSoup& soup, std::span<const PatchedFace> faces, std::span<const PointPair> contacts);

}  // namespace rad::mesh
