// What repair did to a model, operation by operation.
#pragma once

#include <cstdint>
#include <optional>
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
  std::string stage;      ///< name of the filter: "grouper", "isect"…; "input" for what is left out while reading
  std::string operation;  ///< "weld", "insert-t-vertex"…; "roll-back" where the work of the stage is not used
  std::vector<std::string> rules;  ///< ids of the rules that it serves; of a roll-back those that had got worse
  std::uint64_t count = 0;
  double largest_movement = 0;           ///< of a point, file units; 0 for operations that move none
  std::optional<double> area_change;     ///< of all faces, file units²; nothing where it is not known for this alone
  std::vector<LedgerPlace> places = {};  ///< the largest kListedPlaces, of what was lost; empty for other operations
};

inline constexpr std::size_t kListedPlaces = 10;

using Ledger = std::vector<LedgerEntry>;

/// Seconds by stage, in running order.
using StageTimings = std::vector<std::pair<std::string, double>>;

}  // namespace rad::scene
