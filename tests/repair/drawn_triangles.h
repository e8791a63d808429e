// Triangles drawn by hand for the lints, in pitches.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "repair/triangle_lint.h"

namespace rad::tests {

class TriangleSketch {
 public:
  /// A triangle in a cluster of its own; its number.
  std::uint32_t add(const geom::LatticePoint& a, const geom::LatticePoint& b, const geom::LatticePoint& c) {
    return add_in(static_cast<repair::ClusterId>(triangles_.size()), a, b, c);
  }
  std::uint32_t add_in(repair::ClusterId cluster, const geom::LatticePoint& a, const geom::LatticePoint& b,
                       const geom::LatticePoint& c) {
    triangles_.push_back({{point(a), point(b), point(c)}, cluster, true, 0, 0});
    return static_cast<std::uint32_t>(triangles_.size() - 1);
  }

  scene::PointId point(const geom::LatticePoint& place) {
    const auto [entry, added] = ids_.try_emplace(place, static_cast<scene::PointId>(points_.size()));
    if (added) points_.push_back(place);
    return entry->second;
  }

  [[nodiscard]] repair::TriangleSet set() const { return {points_, triangles_, {}, {}}; }
  [[nodiscard]] const std::vector<repair::Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] std::array<geom::LatticePoint, 3> corners(std::uint32_t triangle) const {
    const auto& ids = triangles_[triangle].points;
    return {points_[ids[0]], points_[ids[1]], points_[ids[2]]};
  }

 private:
  std::vector<geom::LatticePoint> points_;
  std::vector<repair::Triangle> triangles_;
  std::map<geom::LatticePoint, scene::PointId> ids_;
};

}  // namespace rad::tests
