#include "solve/shooting.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "solve/light.h"

namespace rad::solve {

namespace {

constexpr std::size_t kFewestPerRound = 16;
constexpr std::size_t kMostPerRound = 128;
constexpr std::size_t kRoundShare = 32;

}  // namespace

std::size_t shots_per_round(std::size_t patches) {
  return std::clamp(patches / kRoundShare, kFewestPerRound, kMostPerRound);
}

Shooting::Shooting(const mesh::RadiosityMesh& mesh, const Radiators& radiators, const PatchSamples& samples,
                   std::span<const scene::Material> materials, CouplingStore& couplings)
    : mesh_(mesh),
      radiators_(radiators),
      couplings_(couplings),
      irradiance_(radiators, samples),
      shot_(radiators.local_receiver.size(), dvec3(0)),
      unshot_(mesh.patches.size()) {
  for (const scene::Material& material : materials) {
    emission_.push_back(exitance(material));
    reflectance_.push_back(material.reflectance);
  }
  for (mesh::PatchId patch = 0; patch < mesh.patches.size(); ++patch) {
    emitted_power_ += emission(patch) * radiators.patch[patch].area;
  }
  update_unshot();
}

Shooting::Unshot Shooting::unshot_of(mesh::PatchId patch) const {
  const Radiator& radiator = radiators_.patch[patch];
  const std::span<const double> shares = radiators_.shares_of(radiator);
  const dvec3 emitted = emission(patch), reflected = reflectance(patch);
  Unshot unshot;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const std::size_t local = radiator.first_local + i;
    const dvec3 left = emitted + reflected * irradiance_.at(local) - shot_[local];
    unshot.power += left * (shares[i] * radiator.area);
    unshot.magnitude += glm::abs(left) * (std::abs(shares[i]) * radiator.area);
  }
  return unshot;
}

void Shooting::update_unshot() {
  tbb::parallel_for(std::size_t{0}, unshot_.size(),
                    [&](std::size_t patch) { unshot_[patch] = unshot_of(static_cast<mesh::PatchId>(patch)); });
}

double Shooting::unshot_share() const {
  dvec3 left{0, 0, 0};
  for (const Unshot& unshot : unshot_) left += unshot.magnitude;
  double share = 0;
  for (int channel = 0; channel < 3; ++channel) {
    if (emitted_power_[channel] > 0) share = std::max(share, left[channel] / emitted_power_[channel]);
  }
  return share;
}

std::vector<mesh::PatchId> Shooting::brightest(std::size_t count) const {
  std::vector<double> power;
  power.reserve(unshot_.size());
  for (const Unshot& unshot : unshot_) power.push_back(unshot.magnitude.x + unshot.magnitude.y + unshot.magnitude.z);
  std::vector<mesh::PatchId> patches(unshot_.size());
  std::iota(patches.begin(), patches.end(), 0);
  count = std::min(count, patches.size());
  std::partial_sort(
      patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(count), patches.end(),
      [&](mesh::PatchId a, mesh::PatchId b) { return power[a] != power[b] ? power[a] > power[b] : a < b; });
  patches.resize(count);
  while (!patches.empty() && !(power[patches.back()] > 0)) patches.pop_back();
  return patches;
}

Shot Shooting::shot_of(mesh::PatchId patch, std::vector<dvec3> at_local) const {
  const Radiator& radiator = radiators_.patch[patch];
  const std::span<const double> shares = radiators_.shares_of(radiator);
  const std::span<const std::array<double, 2>> slopes = radiators_.slopes_of(radiator);
  Shot shot;
  shot.patch = patch;
  shot.at_local = std::move(at_local);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shot.mean += shot.at_local[i] * shares[i];
    for (int axis = 0; axis < 2; ++axis) shot.slope[axis] += shot.at_local[i] * slopes[i][axis];
  }
  return shot;
}

Shot Shooting::take_shot(mesh::PatchId patch) {
  const Radiator& radiator = radiators_.patch[patch];
  std::vector<dvec3> left;
  left.reserve(radiator.local_count);
  for (std::size_t local = radiator.first_local; local < radiator.first_local + radiator.local_count; ++local) {
    const dvec3 radiosity = emission(patch) + reflectance(patch) * irradiance_.at(local);
    left.push_back(radiosity - shot_[local]);
    shot_[local] = radiosity;
  }
  Shot shot = shot_of(patch, std::move(left));
  shot_power_ += shot.mean * radiator.area;
  return shot;
}

Shot Shooting::shot_by(mesh::PatchId patch) const {
  const Radiator& radiator = radiators_.patch[patch];
  const auto first = shot_.begin() + radiator.first_local;
  return shot_of(patch, {first, first + radiator.local_count});
}

void Shooting::receive(const std::vector<Shot>& shots) {
  tbb::parallel_for(std::size_t{0}, couplings_.ranges().size(), [&](std::size_t range) {
    for (const Shot& shot : shots) {
      couplings_.with(shot.patch, range, [&](const Coupling& coupling) { irradiance_.add(shot, coupling); });
    }
    irradiance_.settle(couplings_.ranges()[range]);
  });
}

void Shooting::shoot(std::size_t most) {
  std::vector<Shot> shots;
  for (const mesh::PatchId patch : brightest(std::min(most, shots_per_round(unshot_.size()))))
    shots.push_back(take_shot(patch));
  receive(shots);
  shots_ += shots.size();
  update_unshot();
}

std::vector<dvec3> Shooting::radiosity() const {
  std::vector<dvec3> radiosity(mesh_.nodes.size(), dvec3(0));
  std::vector<bool> known(mesh_.nodes.size(), false);
  for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
    const mesh::Element& element = mesh_.elements[i];
    for (std::uint32_t k = 0; k < element.corners.count; ++k) {
      const mesh::NodeId node = element.corners.node[k];
      if (known[node]) continue;
      known[node] = true;
      const std::size_t local = radiators_.patch[element.patch].first_local + radiators_.element[i][k];
      radiosity[node] = emission(element.patch) + reflectance(element.patch) * irradiance_.at(local);
    }
  }
  return radiosity;
}

dvec3 Shooting::mean_irradiance(mesh::PatchId patch) const {
  const Radiator& radiator = radiators_.patch[patch];
  const std::span<const double> shares = radiators_.shares_of(radiator);
  dvec3 mean{0, 0, 0};
  for (std::size_t i = 0; i < shares.size(); ++i) mean += irradiance_.at(radiator.first_local + i) * shares[i];
  return mean;
}

Importance Shooting::importance() const {
  dvec3 absorbed{0, 0, 0}, left{0, 0, 0};
  for (mesh::PatchId patch = 0; patch < mesh_.patches.size(); ++patch) {
    absorbed += (1.0 - reflectance(patch)) * radiators_.patch[patch].area;
    left += unshot_[patch].magnitude;
  }
  dvec3 ambient{0, 0, 0};
  for (int channel = 0; channel < 3; ++channel) {
    if (absorbed[channel] > 0) ambient[channel] = left[channel] / absorbed[channel];
  }
  Importance result;
  for (mesh::PatchId patch = 0; patch < mesh_.patches.size(); ++patch) {
    const dvec3 irradiance = glm::max(mean_irradiance(patch), dvec3(0)) + ambient;
    result.irradiance.push_back(irradiance);
    result.radiosity.push_back(emission(patch) + reflectance(patch) * irradiance);
  }
  return result;
}

mesh::EnergyLedger Shooting::energy(double metres_per_unit) const {
  const double square_metres = metres_per_unit * metres_per_unit;
  mesh::EnergyLedger ledger;
  for (mesh::PatchId patch = 0; patch < mesh_.patches.size(); ++patch) {
    const Radiator& radiator = radiators_.patch[patch];
    const dvec3 mean = mean_irradiance(patch);
    ledger.received += mean * (radiator.area * square_metres);
    ledger.reflected += reflectance(patch) * mean * (radiator.area * square_metres);
    ledger.unshot += unshot_[patch].power * square_metres;
  }
  ledger.emitted = emitted_power_ * square_metres;
  ledger.shot = shot_power_ * square_metres;
  ledger.absorbed = ledger.received - ledger.reflected;
  ledger.escaped = ledger.shot - ledger.received;
  return ledger;
}

}  // namespace rad::solve
