// A hash grid of points for "who is within the weld distance".
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
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
  void clear() { cells_.clear(); }
  void add(PointId id, const LatticePoint& point) { cells_[key_of(geom::as_vector(point), 0, 0, 0)].push_back(id); }

  template <typename Visit>
  void for_each_near(const dvec3& place, Visit&& visit) const {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const auto found = cells_.find(key_of(place, x, y, z));
          if (found == cells_.end()) continue;
          for (const PointId id : found->second) visit(id);
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

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<PointId>> cells_;
};

}  // namespace rad::repair
