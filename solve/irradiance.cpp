#include "solve/irradiance.h"

namespace rad::solve {

dvec3 arriving(const Shot& shot, const FarWeight& weight) {
  return shot.mean * double{weight[0]} + shot.slope[0] * double{weight[1]} + shot.slope[1] * double{weight[2]};
}

dvec3 arriving(const Shot& shot, std::span<const float> row) {
  dvec3 sum{0, 0, 0};
  for (std::size_t i = 0; i < row.size(); ++i) sum += shot.at_local[i] * double{row[i]};
  return sum;
}

Irradiance::Irradiance(const Radiators& radiators, const PatchSamples& samples)
    : radiators_(radiators),
      samples_(samples),
      own_(radiators.local_receiver.size(), dvec3(0)),
      sampled_(radiators.patch.size()),
      settled_(radiators.local_receiver.size(), dvec3(0)) {
  for (auto& five : sampled_) five.fill(dvec3(0));
}

void Irradiance::add(const Shot& shot, const Coupling& coupling) {
  for (const SampleRow& row : coupling.sample) {
    std::array<dvec3, 5>& five = sampled_[row.patch];
    for (std::size_t i = 0; i < five.size(); ++i) five[i] += arriving(shot, row.weight[i]);
  }
  for (std::size_t i = 0; i < coupling.far_local.size(); ++i) {
    own_[coupling.far_local[i]] += arriving(shot, coupling.far_weight[i]);
  }
  for (std::size_t i = 0; i < coupling.near_local.size(); ++i) {
    const float* row = coupling.near_weight.data() + coupling.near_row[i] * shot.at_local.size();
    own_[coupling.near_local[i]] += arriving(shot, std::span(row, shot.at_local.size()));
  }
}

void Irradiance::settle(PatchRange patches) {
  for (mesh::PatchId patch = patches.first; patch < patches.end; ++patch) {
    const Radiator& radiator = radiators_.patch[patch];
    const std::array<dvec3, 5>& five = sampled_[patch];
    for (std::uint32_t local = radiator.first_local; local < radiator.first_local + radiator.local_count; ++local) {
      dvec3 sum = own_[local];
      for (std::size_t k = 0; k < five.size(); ++k) sum += five[k] * static_cast<double>(samples_.share[local][k]);
      settled_[local] = sum;
    }
  }
}

}  // namespace rad::solve
