// A hash grid of points for "who is within the weld distance".
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
  /// `cell` in pitches: queries see all points within that distance, and some more.
  explicit PointGrid(double cell) : cell_(cell) {}

  [[nodiscard]] double cell() const { return cell_; }
  void clear() {
    newest_.clear();
    before_.clear();
  }
  void add(PointId id, const LatticePoint& point) {
    if (before_.size() <= id) before_.resize(id + std::size_t{1}, scene::kNoPoint);
    const auto [entry, is_new] = newest_.try_emplace(key_of(geom::as_vector(point), 0, 0, 0), id);
    before_[id] = is_new ? scene::kNoPoint : entry->second;
    entry.value() = id;
  }

  template <typename Visit>
  void for_each_near(const dvec3& place, Visit&& visit) const {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const auto found = newest_.find(key_of(place, x, y, z));
          if (found == newest_.end()) continue;
          for (PointId id = found->second; id != scene::kNoPoint; id = before_[id]) visit(id);
        }
      }
    }
  }

 private:
  // 21 bits an axis: the lattice has 24 bits and a cell is at least 8 pitches wide.
  [[nodiscard]] std::uint64_t key_of(const dvec3& place, int dx, int dy, int dz) const {
    const auto part = [&](double value, int step) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / cell_)) + step) & 0x1fffff;
    };
    return part(place.x, dx) << 42 | part(place.y, dy) << 21 | part(place.z, dz);
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
