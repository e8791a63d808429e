// How much of a radiator's radiosity arrives at the patches of a range: form factor and visibility. Depends on geometry
// and on the estimated importance alone.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/coupling_scratch.h"
#include "solve/coupling_source.h"
#include "solve/far_radiator.h"

namespace rad::solve {

/// Patches from `first` up to, not including, `end`.
struct PatchRange {
  mesh::PatchId first = 0;
  mesh::PatchId end = 0;
};

/// What one patch receives of another at its samples, where it changes little over it.
struct SampleRow {
  mesh::PatchId patch = 0;
  std::array<FarWeight, 5> weight{};
};

/// One radiator and the patches of a range. Locals are indices into Radiators::local_receiver. Near a radiator its
/// radiosity may not be taken as a mean and two slopes: then every local of it has a weight. Locals to which nothing
/// comes are not listed.
struct Coupling {
  std::vector<SampleRow> sample;
  std::vector<mesh::PatchId> everywhere;  ///< ascending: patches for which each local is known by itself
  std::vector<std::uint32_t> far_local;
  std::vector<FarWeight> far_weight;
  std::vector<std::uint32_t> near_local;
  std::vector<std::uint32_t> near_row;  ///< for each near local the row of its receiver
  std::vector<float> near_weight;       ///< rows of as many as the radiator has locals

  [[nodiscard]] std::size_t bytes() const;
  void shrink();  ///< gives back memory that is reserved and not used
};

/// The same numbers for the same patch and range. May be called from many threads, each with its own scratch.
Coupling couple(const CouplingSource& source, mesh::PatchId patch, PatchRange range, CouplingScratch& scratch);

}  // namespace rad::solve
