// Patches that lint would call degenerate or a T-vertex: a corner within T of another edge of the patch.
#pragma once

#include <vector>

#include "geom/tolerance.h"
#include "mesh/patch_sectors.h"

namespace rad::mesh {

/// Per face whether one of its patches is thin at `tolerance`. `points` are those that the corners of `soup` name.
std::vector<bool> faces_with_thin_patches(const PatchSoup& soup, const std::vector<geom::LatticePoint>& points,
                                          std::size_t face_count, const geom::Tolerance& tolerance);

}  // namespace rad::mesh
