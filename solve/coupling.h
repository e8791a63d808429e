// How much of a radiator's radiosity arrives at each receiver: form factor and visibility. Depends on geometry alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solve/radiators.h"
#include "solve/visibility.h"

namespace rad::solve {

/// Receivers from `first` up to, not including, `end`.
struct ReceiverRange {
  ReceiverId first = 0;
  ReceiverId end = 0;
};

/// One patch seen by a range of receivers. A receiver that is far takes the patch as one radiator whose radiosity
/// has a mean and two slopes. To one that is near its radiosity is not constant (radiator subdivision, [BAUM89]): there
/// each local of the patch has a weight of its own, that of its shape. Receivers that see nothing of the patch are not
/// listed.
struct Coupling {
  std::vector<ReceiverId> far_receiver;
  std::vector<std::array<float, 3>> far_weight;  ///< of the mean and the two slopes
  std::vector<ReceiverId> near_receiver;
  std::vector<float> near_weight;  ///< for each near receiver as many as the patch has locals

  [[nodiscard]] std::size_t bytes() const;
  void shrink();  ///< gives back memory that is reserved and not used
};

/// What couplings are computed from. All that is referred to outlives it.
struct CouplingSource {
  const mesh::RadiosityMesh& mesh;
  const Radiators& radiators;
  std::span<const Receiver> receivers;  ///< receivers_of(mesh)
  const std::vector<bool>& principal;   ///< one for each patch; principal emitters get more strata
  const Visibility& visibility;
  double lift = 0;  ///< lift_of(mesh)

  /// The same numbers for the same patch and receiver whatever the range. May be called from many threads.
  [[nodiscard]] Coupling couple(mesh::PatchId patch, ReceiverRange range) const;
};

}  // namespace rad::solve
