#include "solve/solver.h"

#include <algorithm>
#include <cmath>

#include "solve/draft.h"
#include "solve/shooting.h"

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

mesh::RadiosityField solve(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                           const SolveOptions& options, Progress& progress) {
  const Visibility visibility(mesh);
  const std::vector<Receiver> receivers = receivers_of(mesh);
  const Radiators radiators = radiators_of(mesh, receivers);
  const PatchSamples samples = patch_samples(mesh, radiators);
  Importance importance;
  const CouplingSource source{mesh, radiators, receivers, samples, visibility, importance, lift_of(mesh)};
  importance = draft_importance(source, materials);
  importance.noise = noise_for(radiators);
  CouplingStore couplings(source, options.coupling_bytes);
  Shooting shooting(mesh, radiators, samples, materials, couplings);

  mesh::RadiosityField field;
  while (true) {
    const double unshot = shooting.unshot_share();
    if (unshot <= options.unshot_limit) break;
    const bool spent = options.shot_limit > 0 && shooting.shots() >= options.shot_limit;
    if (spent || !progress.go_on(unshot, shooting.shots())) {
      field.complete = false;
      break;
    }
    shooting.shoot(options.shot_limit > 0 ? options.shot_limit - shooting.shots() : mesh.patches.size());
  }
  field.radiosity = shooting.radiosity();
  field.energy = shooting.energy(options.metres_per_unit);
  field.shots = shooting.shots();
  return field;
}

}  // namespace rad::solve
