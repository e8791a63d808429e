// Which faces gave way to which where they overlapped in one plane: what users argue about, so all of it is told.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/finding.h"

namespace rad::scene {

/// All cells in which surfaces of one object and material hid those of another, for one reason.
struct CoplanarRemoval {
  struct Side {
    std::string object;
    std::string material;
    FaceReference face;  ///< of the input, at the largest cell
  };
  Side winner;
  Side loser;
  char rule = 'e';          ///< of repair/surface_order.h: OrderRule
  bool tie = false;         ///< different materials, and nothing but names and places decided
  std::uint64_t count = 0;  ///< cells
  double area = 0;          ///< file units², of all cells
  dvec3 point{0, 0, 0};     ///< file units, the middle of the largest cell
};

using CoplanarRemovals = std::vector<CoplanarRemoval>;

}  // namespace rad::scene
