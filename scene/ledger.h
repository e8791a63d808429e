// What repair did to a model, operation by operation.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rad::scene {

struct LedgerEntry {
  std::string stage;      ///< of the paper: "grouper", "isect", "coplanar"; "orient" for the turning of faces
  std::string operation;  ///< "weld", "insert-t-vertex"…
  std::uint64_t count = 0;
  double largest_movement = 0;  ///< of a point, file units; 0 for operations that move none
};

using Ledger = std::vector<LedgerEntry>;

/// Seconds by stage, in running order.
using StageTimings = std::vector<std::pair<std::string, double>>;

}  // namespace rad::scene
