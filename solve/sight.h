// Which strata of a radiator a receiver sees: one jittered ray for each stratum.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solve/receivers.h"
#include "solve/visibility.h"

namespace rad::solve {

/// A radiator made of cells, split into strata finer and finer: step[s] holds 4^level[s] strata for each cell, by cell.
struct StratifiedRadiator {
  std::uint32_t key = 0;  ///< goes into the jitter
  dvec3 lift;             ///< from the radiator's plane to where rays end
  std::vector<Stratum> cell;
  std::vector<std::uint32_t> level;
  std::vector<std::vector<Stratum>> step;
};

/// Steps with at least `fewest` strata in all, and where these disagree with at least `most`.
StratifiedRadiator stratified(std::uint32_t key, const dvec3& lift, std::vector<Stratum> cells, std::size_t fewest,
                              std::size_t most);

enum class Vote : std::uint8_t { BelowHorizon, Visible, Blocked };

/// What one receiver sees of a radiator, at the step at which its strata agreed or at the last one.
struct Sight {
  ReceiverId receiver = 0;
  std::size_t step = 0;
  std::size_t first_vote = 0;  ///< one for each stratum of the step
  std::uint32_t visible = 0;
  std::uint32_t blocked = 0;
};

struct Sights {
  std::vector<Sight> sight;
  std::vector<Vote> vote;

  [[nodiscard]] const Vote* votes_of(const Sight& seen) const { return vote.data() + seen.first_vote; }
};

/// Sights of these receivers (indices into `receivers`, all in front of the radiator's plane), in their order.
Sights look(const StratifiedRadiator& radiator, std::span<const ReceiverId> receiver_ids,
            std::span<const Receiver> receivers, const Visibility& visibility);

}  // namespace rad::solve
