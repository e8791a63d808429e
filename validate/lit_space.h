// Which air cells light may reach.
#pragma once

#include <optional>
#include <vector>

#include "validate/air_cells.h"
#include "validate/conforming_sheets.h"

namespace rad::validate {

/// Light stays in the cells that it starts in: a line of sight passes through no triangle. Emitters shine from their
/// fronts. Where no material emits, open space is taken for lit and so is every cell that is walled by fronts for the
/// larger part of its area: a room.
struct LitSpace {
  Sheets sheets;
  AirCells cells;
  bool has_emitters = false;
  std::vector<bool> lit;         ///< per cell
  std::vector<bool> may_be_lit;  ///< also cells at the back of an emitter that is not closed: it may be turned over

  [[nodiscard]] CellId cell(std::uint32_t triangle, int side) const { return cells.cell_of_side[triangle][side]; }
  /// The face whose back is seen on that side of a triangle; kNoFace where it is a front.
  [[nodiscard]] FaceId back(std::uint32_t triangle, int side) const {
    return sheets.front[triangle][side] == kNoFace ? sheets.front[triangle][1 - side] : kNoFace;
  }
};

/// Nothing where the model is not conforming.
std::optional<LitSpace> find_lit_space(const Context& context);

}  // namespace rad::validate
