// A patch as near receivers see it: its radiosity is not constant there, and every local has a weight of its own
// (radiator subdivision, [BAUM89]).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solve/coupling_source.h"
#include "solve/sight.h"

namespace rad::solve {

/// Strata are made when they are needed first, so an object is for one thread.
class NearRadiator {
 public:
  NearRadiator(const CouplingSource& source, mesh::PatchId patch);

  /// Appends for each of the receivers, all in front of the patch's plane, as many weights as the patch has locals;
  /// they are looked for with 4^level strata in all, or as many as the patch has elements if that is more.
  void look(std::span<const ReceiverId> receivers, int level, std::vector<float>& weights);

 private:
  const StratifiedRadiator& strata_for(int level);
  void add_weights(const StratifiedRadiator& radiator, const Sight& sight, const Vote* vote);

  const CouplingSource& source_;
  mesh::PatchId patch_;
  const Radiator& radiator_;
  std::array<std::optional<StratifiedRadiator>, kDeepestStrata + 1> strata_;
  std::vector<double> weight_;  ///< of one receiver
};

}  // namespace rad::solve
