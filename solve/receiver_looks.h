// One radiator seen from single receivers: near ones give every local of it a weight of its own, the others its mean
// and two slopes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solve/coupling_scratch.h"
#include "solve/far_radiator.h"
#include "solve/near_radiator.h"

namespace rad::solve {

/// Weights are the same for the same receiver, whatever the others are. For one thread; `scratch` is its own while the
/// object lives.
class ReceiverLooks {
 public:
  ReceiverLooks(const CouplingSource& source, mesh::PatchId patch, CouplingScratch& scratch);

  /// `importance` is Importance::of the radiator and a patch of the receiver; of more requests for one receiver the
  /// first counts.
  void request_far(ReceiverId receiver, double importance);
  /// Near, where it is.
  void request(ReceiverId receiver, double importance);
  /// At what was requested since the last time, but for the near.
  void look_far() { far_.look(std::span(requests_).subspan(views_.size()), views_); }
  /// At all that are near, once; appends for each a row with as many weights as the radiator has locals.
  void look_near(std::vector<float>& weights);

  /// After look_far(), of a receiver that was requested and is not near.
  [[nodiscard]] const FarView& view(ReceiverId receiver) const { return views_[scratch_.far.find(receiver)]; }
  /// After look_near(): its row, nothing where it is not near.
  [[nodiscard]] std::optional<std::uint32_t> near_row(ReceiverId receiver) const;

 private:
  /// False where the receiver is not near.
  bool request_near(ReceiverId receiver, double importance);

  const CouplingSource& source_;
  mesh::PatchId patch_;
  CouplingScratch& scratch_;
  FarRadiator far_;
  NearRadiator near_;
  std::vector<FarRequest> requests_;  ///< by number in scratch_.far
  std::vector<FarView> views_;        ///< likewise
  std::vector<int> near_level_;       ///< by number in scratch_.near
  std::vector<std::uint32_t> row_;    ///< likewise
};

}  // namespace rad::solve
