// What couplings are computed from.
#pragma once

#include <span>

#include "solve/importance.h"
#include "solve/patch_samples.h"
#include "solve/visibility.h"

namespace rad::solve {

/// All that is referred to outlives it.
struct CouplingSource {
  const mesh::RadiosityMesh& mesh;
  const Radiators& radiators;
  std::span<const Receiver> receivers;  ///< receivers_of(mesh)
  const PatchSamples& samples;
  const Visibility& visibility;
  const Importance& importance;
  double lift = 0;            ///< lift_of(mesh)
  bool samples_only = false;  ///< all patches receive at their samples alone: a draft
};

}  // namespace rad::solve
