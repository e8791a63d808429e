#include "solve/solution.h"

#include <algorithm>
#include <cmath>

#include "solve/draft.h"

namespace rad::solve {
namespace {

/// What one pair may make of an error, as a share of the irradiance, in a solution of kUsualPairs pairs of patch and
/// local and more. Smaller ones have time for less.
constexpr double kNoise = 1.5e-3;
constexpr double kLeastNoise = 2e-4;
constexpr double kUsualPairs = 1e9;

double noise_for(const Radiators& radiators) {
  const double pairs =
      static_cast<double>(radiators.patch.size()) * static_cast<double>(radiators.local_receiver.size());
  return std::clamp(kNoise * std::sqrt(pairs / kUsualPairs), kLeastNoise, kNoise);
}

}  // namespace

Solution::Solution(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                   const SolveOptions& options)
    : mesh_(mesh),
      options_(options),
      visibility_(mesh),
      receivers_(receivers_of(mesh)),
      radiators_(radiators_of(mesh, receivers_)),
      samples_(patch_samples(mesh, radiators_)),
      source_{mesh, radiators_, receivers_, samples_, visibility_, importance_, lift_of(mesh)},
      couplings_(source_, options.coupling_bytes),
      shooting_(mesh, radiators_, samples_, materials, couplings_) {
  importance_ = draft_importance(source_, materials);
  importance_.noise = noise_for(radiators_);
}

bool Solution::run(Progress& progress) {
  while (true) {
    const double unshot = shooting_.unshot_share();
    if (unshot <= options_.unshot_limit) return true;
    const bool spent = options_.shot_limit > 0 && shooting_.shots() >= options_.shot_limit;
    if (spent || !progress.go_on(unshot, shooting_.shots())) return false;
    shooting_.shoot(options_.shot_limit > 0 ? options_.shot_limit - shooting_.shots() : mesh_.patches.size());
  }
}

}  // namespace rad::solve
