// The log of Coplanar: every cell that was removed, added up for those who hid and those who gave way.
#pragma once

#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "geom/lattice.h"
#include "repair/conform.h"
#include "repair/surface_order.h"
#include "scene/coplanar_removal.h"

namespace rad::repair {

class CoplanarLog {
 public:
  /// Adds the cells of one pass, which `order` decided. `origin` names the face of the input for every face of the
  /// pass; empty where they are the same.
  void add(std::span<const CoveredCell> cells, const SurfaceOrder& order, std::span<const scene::FaceId> origin);

  /// Largest area first. `input` is the scene that was repaired.
  [[nodiscard]] scene::CoplanarRemovals removals(const scene::Scene& input, const geom::Lattice& lattice) const;
  /// Whether a face of the input lost a cell.
  [[nodiscard]] bool gave_way(scene::FaceId face) const;

 private:
  struct Sum {
    std::uint64_t count = 0;
    double area = 0;          ///< pitches²
    double largest_cell = 0;  ///< pitches²
    dvec3 middle{0, 0, 0};    ///< of the largest cell, pitches
  };
  /// Winner and loser, faces of the input, and the reason.
  using Pair = std::tuple<scene::FaceId, scene::FaceId, OrderRule>;

  std::map<Pair, Sum> sums_;
  std::vector<bool> gave_way_;
};

}  // namespace rad::repair
