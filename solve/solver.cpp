#include "solve/solver.h"

#include "solve/light.h"
#include "solve/receivers.h"
#include "solve/shooting.h"

namespace rad::solve {
namespace {

std::vector<bool> emitters(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials) {
  std::vector<bool> emits;
  emits.reserve(mesh.patches.size());
  for (const mesh::Patch& patch : mesh.patches) emits.push_back(materials[patch.material].emits());
  return emits;
}

}  // namespace

mesh::RadiosityField solve(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                           const SolveOptions& options, Progress& progress) {
  const Visibility visibility(mesh);
  const std::vector<Receiver> receivers = receivers_of(mesh);
  const Radiators radiators = radiators_of(mesh, receivers);
  const std::vector<bool> emits = emitters(mesh, materials);
  const CouplingSource source{mesh, radiators, receivers, emits, visibility, lift_of(mesh)};
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
