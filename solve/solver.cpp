#include "solve/solver.h"

#include <numeric>

#include "solve/light.h"
#include "solve/receivers.h"
#include "solve/shooting.h"

namespace rad::solve {
namespace {

/// Share of the emitted power from which a patch is a principal emitter: one whose shadow is seen by itself. The strata
/// of many weaker ones add up.
constexpr double kPrincipalShare = 1.0 / 256;

std::vector<bool> principal_emitters(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials) {
  std::vector<double> power;
  power.reserve(mesh.patches.size());
  for (const mesh::Patch& patch : mesh.patches) {
    const dvec3 emitted = exitance(materials[patch.material]);
    power.push_back((emitted.x + emitted.y + emitted.z) * patch.area);
  }
  const double least = kPrincipalShare * std::accumulate(power.begin(), power.end(), 0.0);
  std::vector<bool> principal;
  principal.reserve(power.size());
  for (const double own : power) principal.push_back(own > 0 && own >= least);
  return principal;
}

}  // namespace

mesh::RadiosityField solve(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                           const SolveOptions& options, Progress& progress) {
  const Visibility visibility(mesh);
  const std::vector<Receiver> receivers = receivers_of(mesh);
  const Radiators radiators = radiators_of(mesh, receivers);
  const std::vector<bool> principal = principal_emitters(mesh, materials);
  const CouplingSource source{mesh, radiators, receivers, principal, visibility, lift_of(mesh)};
  CouplingStore couplings(source, options.coupling_bytes);
  Shooting shooting(mesh, radiators, materials, couplings);

  mesh::RadiosityField field;
  while (true) {
    const double unshot = shooting.unshot_share();
    if (unshot <= options.unshot_limit) break;
    const bool spent = options.shot_limit > 0 && shooting.shots() >= options.shot_limit;
    if (spent || !progress.go_on(unshot, shooting.shots())) {
      field.complete = false;
      break;
    }
    shooting.shoot(options.shot_limit > 0 ? options.shot_limit - shooting.shots() : kShotsPerRound);
  }
  field.radiosity = shooting.radiosity();
  field.energy = shooting.energy(options.metres_per_unit);
  field.shots = shooting.shots();
  return field;
}

}  // namespace rad::solve
