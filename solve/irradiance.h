// What has arrived so far at every local of every patch.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solve/coupling.h"

namespace rad::solve {

/// One patch sending radiosity, W/m².
struct Shot {
  mesh::PatchId patch = 0;
  dvec3 mean{0, 0, 0};
  std::array<dvec3, 2> slope{dvec3(0), dvec3(0)};
  std::vector<dvec3> at_local;
};

/// What arrives of a shot, W/m²: by its mean and slopes, or by a row of as many weights as the radiator has locals.
dvec3 arriving(const Shot& shot, const FarWeight& weight);
dvec3 arriving(const Shot& shot, std::span<const float> row);

/// Different patches may be added to and settled at the same time.
class Irradiance {
 public:
  Irradiance(const Radiators& radiators, const PatchSamples& samples);

  void add(const Shot& shot, const Coupling& coupling);
  /// Brings at() of these patches up to date with what was added.
  void settle(PatchRange patches);
  /// Of a local of the radiators, W/m².
  [[nodiscard]] const dvec3& at(std::size_t local) const { return settled_[local]; }
  /// At the samples of a patch, of what is known at these alone, W/m².
  [[nodiscard]] const std::array<dvec3, 5>& sampled(mesh::PatchId patch) const { return sampled_[patch]; }

 private:
  const Radiators& radiators_;
  const PatchSamples& samples_;
  std::vector<dvec3> own_;                     ///< per local, of what is known there
  std::vector<std::array<dvec3, 5>> sampled_;  ///< per patch, of what is known at its samples
  std::vector<dvec3> settled_;
};

}  // namespace rad::solve
