// A hash grid of points for "who is within this distance".
#pragma once

#include <tsl/robin_map.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "geom/vec.h"
#include "scene/lattice_model.h"

namespace rad::repair {

using geom::dvec3;
using geom::LatticePoint;
using scene::PointId;

class PointGrid {
 public:
  /// `cell` in pitches: a search walks the cells that its reach meets, so a cell a few times as wide as that is quick.
  explicit PointGrid(double cell) : cell_(cell) {}

  void clear() {
    newest_.clear();
    before_.clear();
  }
  void add(PointId id, const LatticePoint& point) {
    if (before_.size() <= id) before_.resize(id + std::size_t{1}, scene::kNoPoint);
    const auto [entry, is_new] = newest_.try_emplace(key_of(cell_of(geom::as_vector(point))), id);
    before_[id] = is_new ? scene::kNoPoint : entry->second;
    entry.value() = id;
  }

  /// Calls visit(point) for all points within `reach` of the place, and some more.
  template <typename Visit>
  void for_each_near(const dvec3& place, double reach, Visit&& visit) const {
    const Cell low = cell_of(place - dvec3(reach)), high = cell_of(place + dvec3(reach));
    for (std::int64_t x = low.x; x <= high.x; ++x) {
      for (std::int64_t y = low.y; y <= high.y; ++y) {
        for (std::int64_t z = low.z; z <= high.z; ++z) {
          const auto found = newest_.find(key_of({x, y, z}));
          if (found == newest_.end()) continue;
          for (PointId id = found->second; id != scene::kNoPoint; id = before_[id]) visit(id);
        }
      }
    }
  }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
  };
  [[nodiscard]] Cell cell_of(const dvec3& place) const {
    const auto part = [&](double value) { return static_cast<std::int64_t>(std::floor(value / cell_)); };
    return {part(place.x), part(place.y), part(place.z)};
  }
  // 21 bits an axis: the lattice has 24 bits and a cell is at least 8 pitches wide.
  static std::uint64_t key_of(const Cell& cell) {
    const auto part = [](std::int64_t value) { return static_cast<std::uint64_t>(value) & 0x1fffff; };
    return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);
  }

  struct KeyHash {
    std::size_t operator()(std::uint64_t key) const {
      const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(mixed ^ (mixed >> 32));
    }
  };

  double cell_;
  tsl::robin_map<std::uint64_t, PointId, KeyHash> newest_;  ///< per cell: the point added last
  std::vector<PointId> before_;                             ///< per point: the one added to its cell before it
};

}  // namespace rad::repair
