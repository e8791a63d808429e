// Finding the triangles near a place or a segment.
#pragma once

#include <algorithm>
#include <vector>

#include "geom/box_tree.h"
#include "repair/distance.h"
#include "repair/triangulation.h"

namespace rad::repair {

class TriangleSearch {
 public:
  TriangleSearch(const Complex& complex, const Triangulation& triangulation)
      : complex_(complex), triangles_(triangulation.triangles()), tree_(boxes()) {}

  [[nodiscard]] std::array<dvec3, 3> corners(const Triangle& triangle) const {
    return {complex_.place(triangle.points[0]), complex_.place(triangle.points[1]), complex_.place(triangle.points[2])};
  }
  [[nodiscard]] double distance(const dvec3& place, const Triangle& triangle) const {
    return distance_to_triangle(place, corners(triangle));
  }
  /// Triangles whose boxes the segment comes within `reach` of, ascending.
  [[nodiscard]] std::vector<std::uint32_t> near_segment(const dvec3& from, const dvec3& to, double reach) const {
    std::vector<std::uint32_t> found;
    tree_.for_each_near_segment(from, to, reach, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    return found;
  }
  /// Whether a triangle of the cluster comes within `reach` of the place.
  [[nodiscard]] bool in_region(ClusterId cluster, const dvec3& place, double reach) const {
    bool inside = false;
    tree_.for_each_near_segment(place, place, reach, [&](std::uint32_t i) {
      inside = inside || (triangles_[i].cluster == cluster && distance(place, triangles_[i]) <= reach);
    });
    return inside;
  }

 private:
  [[nodiscard]] std::vector<geom::LatticeBox> boxes() const {
    std::vector<geom::LatticeBox> list;
    list.reserve(triangles_.size());
    for (const Triangle& triangle : triangles_) {
      const std::array corners{complex_.point(triangle.points[0]), complex_.point(triangle.points[1]),
                               complex_.point(triangle.points[2])};
      list.push_back(geom::box_of(corners));
    }
    return list;
  }

  const Complex& complex_;
  const std::vector<Triangle>& triangles_;
  geom::BoxTree tree_;
};

}  // namespace rad::repair
