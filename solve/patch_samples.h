// Five receivers that stand for all of a patch where what arrives changes little over it.
#pragma once

#include <array>
#include <vector>

#include "solve/radiators.h"

namespace rad::solve {

/// The corners of each patch and its centre, and how the irradiance at its locals follows from theirs: by the quadratic
/// through the five (shape_at).
struct PatchSamples {
  /// Per patch; of a triangle the fourth is the first, with shares of 0.
  std::vector<std::array<ReceiverId, 5>> receiver;
  std::vector<std::array<float, 5>> share;  ///< per local of the radiators; the sum is 1
};

PatchSamples patch_samples(const mesh::RadiosityMesh& mesh, const Radiators& radiators);

}  // namespace rad::solve
