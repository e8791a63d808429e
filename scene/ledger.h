// What repair did to a model, operation by operation.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/finding.h"

namespace rad::scene {

/// Where something was lost: a face of the input.
struct LedgerPlace {
  dvec3 point{0, 0, 0};  ///< file units
  FaceReference face;
  double area = 0;  ///< file units², of the face or of the sides that were joined
};

struct LedgerEntry {
  std::string stage;      ///< of the paper: "grouper", "isect", "coplanar"; "orient" for the turning of faces
  std::string operation;  ///< "weld", "insert-t-vertex"…
  std::uint64_t count = 0;
  double largest_movement = 0;           ///< of a point, file units; 0 for operations that move none
  std::vector<LedgerPlace> places = {};  ///< the largest kListedPlaces, of what was lost; empty for other operations
};

inline constexpr std::size_t kListedPlaces = 10;

using Ledger = std::vector<LedgerEntry>;

/// Seconds by stage, in running order.
using StageTimings = std::vector<std::pair<std::string, double>>;

}  // namespace rad::scene
