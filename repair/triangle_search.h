// Finding the triangles of plane clusters near a place or a segment.
#pragma once

#include <algorithm>
#include <vector>

#include "geom/growing_box_tree.h"
#include "repair/distance.h"
#include "repair/triangulation.h"

namespace rad::repair {

class TriangleSearch {
 public:
  explicit TriangleSearch(const Complex& complex) : complex_(complex) {}

  /// Takes in the triangles that are new. Their numbers: from `first_new()` before the call on.
  void update(const Triangulation& triangulation);
  [[nodiscard]] std::uint32_t first_new() const { return searched_; }

  [[nodiscard]] std::array<dvec3, 3> corners(const Triangle& triangle) const {
    return {complex_.place(triangle.points[0]), complex_.place(triangle.points[1]), complex_.place(triangle.points[2])};
  }
  [[nodiscard]] geom::LatticeBox box(const Triangle& triangle, std::int32_t inflation = 0) const {
    return geom::box_of(std::array{complex_.point(triangle.points[0]), complex_.point(triangle.points[1]),
                                   complex_.point(triangle.points[2])},
                        inflation);
  }
  [[nodiscard]] double distance(const dvec3& place, const Triangle& triangle) const {
    return distance_to_triangle(place, corners(triangle));
  }
  /// Calls visit(number) for every triangle that is there whose box the segment comes within `reach` of.
  template <typename Visit>
  void for_each_near_segment(const dvec3& from, const dvec3& to, double reach, Visit&& visit) const {
    tree_.for_each_near_segment(from, to, reach, [&](std::uint32_t i) {
      if (triangulation_->alive()[i]) visit(i);
    });
  }
  /// Calls visit(triangle) for every one whose box meets `box`.
  template <typename Visit>
  void for_each_meeting(const geom::LatticeBox& box, Visit&& visit) const {
    tree_.for_each_meeting(box, [&](std::uint32_t i) {
      if (triangulation_->alive()[i]) visit(triangulation_->triangles()[i]);
    });
  }
  /// Whether a triangle of the cluster comes within `reach` of the place.
  [[nodiscard]] bool in_region(ClusterId cluster, const dvec3& place, double reach) const {
    bool inside = false;
    tree_.for_each_near_segment(place, place, reach, [&](std::uint32_t i) {
      const Triangle& triangle = triangulation_->triangles()[i];
      inside =
          inside || (triangle.cluster == cluster && triangulation_->alive()[i] && distance(place, triangle) <= reach);
    });
    return inside;
  }

 private:
  const Complex& complex_;
  const Triangulation* triangulation_ = nullptr;
  geom::GrowingBoxTree tree_;
  std::uint32_t searched_ = 0;  ///< triangles below this are in the tree, as far as they are of clusters
};

inline void TriangleSearch::update(const Triangulation& triangulation) {
  triangulation_ = &triangulation;
  const auto triangles = triangulation.triangles();
  std::vector<geom::LatticeBox> boxes;
  std::vector<std::uint32_t> items;
  for (; searched_ < triangles.size(); ++searched_) {
    if (triangles[searched_].cluster == kNoCluster) continue;
    boxes.push_back(box(triangles[searched_]));
    items.push_back(searched_);
  }
  // Hidden ones may come back.
  tree_.add(std::move(boxes), std::move(items), [&](std::uint32_t i) { return triangulation.exists(i); });
}

}  // namespace rad::repair
