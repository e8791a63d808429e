// Progressive refinement in residual form.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/radiosity_field.h"
#include "mesh/radiosity_mesh.h"
#include "scene/scene.h"
#include "solve/coupling_store.h"
#include "solve/importance.h"
#include "solve/irradiance.h"

namespace rad::solve {

/// Patches of a mesh that shoot together. One at a time would take fewer shots, leave most cores without work, and
/// every round looks through all patches.
std::size_t shots_per_round(std::size_t patches);

/// For each local of a patch the irradiance and the radiosity shot so far. Unshot is what is left: emission +
/// reflectance · irradiance - shot. All that is referred to outlives the object.
class Shooting {
 public:
  Shooting(const mesh::RadiosityMesh& mesh, const Radiators& radiators, const PatchSamples& samples,
           std::span<const scene::Material> materials, CouplingStore& couplings);

  /// One round: the patches with the most unshot power, ties by id, at most `most` and at most shots_per_round().
  void shoot(std::size_t most);

  /// The unshot power, summed without sign over the locals, as a share of the emitted: the largest over the channels.
  /// 0 without emission.
  [[nodiscard]] double unshot_share() const;
  [[nodiscard]] std::size_t shots() const { return shots_; }
  /// Of every node, by the material of the first element that it belongs to; 0 for a node of none.
  [[nodiscard]] std::vector<dvec3> radiosity() const;
  /// All that a patch has shot so far.
  [[nodiscard]] Shot shot_by(mesh::PatchId patch) const;
  [[nodiscard]] const Irradiance& irradiance() const { return irradiance_; }
  /// Exitance and reflectance of a patch.
  [[nodiscard]] dvec3 emission(mesh::PatchId patch) const { return emission_[mesh_.patches[patch].material]; }
  [[nodiscard]] dvec3 reflectance(mesh::PatchId patch) const { return reflectance_[mesh_.patches[patch].material]; }
  [[nodiscard]] mesh::EnergyLedger energy(double metres_per_unit) const;
  /// What this would come to, patch by patch, if all that is unshot were spread evenly over all surfaces.
  [[nodiscard]] Importance importance() const;

 private:
  struct Unshot {
    dvec3 power{0, 0, 0};      ///< area · mean
    dvec3 magnitude{0, 0, 0};  ///< the same with the share of every local taken without its sign
  };

  [[nodiscard]] Unshot unshot_of(mesh::PatchId patch) const;
  /// `at_local` has one for each local of the patch.
  [[nodiscard]] Shot shot_of(mesh::PatchId patch, std::vector<dvec3> at_local) const;
  [[nodiscard]] Shot take_shot(mesh::PatchId patch);
  [[nodiscard]] std::vector<mesh::PatchId> brightest(std::size_t count) const;
  void receive(const std::vector<Shot>& shots);
  void update_unshot();
  [[nodiscard]] dvec3 mean_irradiance(mesh::PatchId patch) const;

  const mesh::RadiosityMesh& mesh_;
  const Radiators& radiators_;
  CouplingStore& couplings_;
  std::vector<dvec3> emission_;     ///< exitance of each material
  std::vector<dvec3> reflectance_;  ///< of each material
  Irradiance irradiance_;
  std::vector<dvec3> shot_;     ///< radiosity shot, at each local of each patch
  std::vector<Unshot> unshot_;  ///< of each patch
  dvec3 emitted_power_{0, 0, 0};
  dvec3 shot_power_{0, 0, 0};
  std::size_t shots_ = 0;
};

}  // namespace rad::solve
