// Where the outlines of things, seen from a point of a light, throw the borders of their shadows (instead of the raster
// of paper 3.4.3: no shadow is too fine).
#pragma once

#include <span>
#include <vector>

#include "mesh/light_samples.h"
#include "mesh/patch_rays.h"

namespace rad::mesh {

/// A straight piece of a shadow's border in the plane of the patches of its ends, which belong to one face.
struct ShadowLine {
  std::array<dvec3, 2> end;  ///< lattice coordinates
  std::array<PatchId, 2> patch{};
};

/// Traces the edges that the lights see against what lies behind them. Borders are found whole where they are longer
/// than `finest` (pitches) on one face; a piece is at most twice as long. The same whatever the number of threads.
std::vector<ShadowLine> shadow_lines(const ElementMesh& mesh, const PatchRays& rays,
                                     std::span<const LightSample> lights, double finest);

}  // namespace rad::mesh
