// One mesh with all that is needed to solve it, and to ask more of the solution.
#pragma once

#include <span>
#include <vector>

#include "solve/coupling_store.h"
#include "solve/shooting.h"
#include "solve/solver.h"

namespace rad::solve {

/// What it is made from outlives it.
class Solution {
 public:
  Solution(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials, const SolveOptions& options);
  Solution(const Solution&) = delete;
  Solution& operator=(const Solution&) = delete;

  /// False where it was stopped before the limit.
  bool run(Progress& progress);

  [[nodiscard]] const Shooting& shooting() const { return shooting_; }
  [[nodiscard]] const Radiators& radiators() const { return radiators_; }
  /// For replay().
  [[nodiscard]] const CouplingSource& source() const { return source_; }
  [[nodiscard]] CouplingStore& couplings() { return couplings_; }

 private:
  const mesh::RadiosityMesh& mesh_;
  const SolveOptions options_;
  const Visibility visibility_;
  const std::vector<Receiver> receivers_;
  const Radiators radiators_;
  const PatchSamples samples_;
  Importance importance_;
  const CouplingSource source_;
  CouplingStore couplings_;
  Shooting shooting_;
};

}  // namespace rad::solve
