// The state of one round of the residual loop; its parts are in residual.cpp, rehoming.cpp, slivers.cpp and
// local_merges.cpp.
#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "repair/residual.h"

namespace rad::repair {

struct Residual::Round {
  Residual& residual;
  Complex& complex;
  const Triangulation& triangulation;
  Effort effort;
  double reach;
  bool changed = false;
  std::vector<bool> moved;  ///< per triangle: re-homed in this round
  std::vector<std::pair<EdgeKey, PointId>> splits;
  std::vector<std::pair<ClusterId, EdgeKey>> imprints;

  Round(Residual& owner, const Triangulation& triangles, Effort how_hard, double new_point_reach)
      : residual(owner),
        complex(owner.complex_),
        triangulation(triangles),
        effort(how_hard),
        reach(new_point_reach),
        moved(triangles.triangles().size(), false) {}

  [[nodiscard]] const Triangle& triangle(std::uint32_t i) const { return triangulation.triangles()[i]; }
  [[nodiscard]] const Plane& plane(ClusterId id) const { return complex.clusters()[id].plane; }
  [[nodiscard]] std::array<dvec3, 3> corners(const Triangle& t) const {
    return {complex.place(t.points[0]), complex.place(t.points[1]), complex.place(t.points[2])};
  }
  [[nodiscard]] dvec3 normal(const Triangle& t) const {
    const auto v = corners(t);
    return glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
  }
  /// Height of a point over the plane of a triangle.
  [[nodiscard]] double height(const Triangle& over, const dvec3& unit_normal, PointId id) const {
    return glm::dot(complex.place(id) - complex.place(over.points[0]), unit_normal);
  }

  bool cure_stacking();
  void cure(const Violation& violation);
  bool finish();
  bool merge_closest(std::span<const Violation> violations);

  bool imprint_point(ClusterId cluster, PointId id);
  void imprint_edge(ClusterId cluster, EdgeKey edge);

  void cut(const Triangle& a, const Triangle& b);
  void cut_edges_of(const Triangle& s, const Triangle& t, std::vector<PointId>& common);
  void draw_together(const Triangle& a, const Triangle& b, double near);
  bool adds(const Triangle& a, const Triangle& b, double near);
  void overlay(const Triangle& a, const Triangle& b);
  void join(const Triangle& a, const Triangle& b);
  bool join_edges(const Triangle& a, const Triangle& b);
  void clear_edge(const Triangle& t, std::uint32_t corner, PointId point);
  /// On a: the middle of where two that are nearly coplanar lie over each other.
  [[nodiscard]] dvec3 middle_of_contact(const Triangle& a, const Triangle& b) const;
  [[nodiscard]] bool nearly_coplanar(const Triangle& a, const Triangle& b) const;

  bool rehome(const Violation& violation);
  bool rehome_one(std::uint32_t which, std::uint32_t other);
  [[nodiscard]] bool fits_plane(const Triangle& t, const Triangle& other) const;
  [[nodiscard]] bool overlaps_far(const Triangle& t, ClusterId target) const;

  void relieve_sliver(const Triangle& t, PointId u, PointId v, PointId point);
  bool place_steiner(ClusterId cluster, PointId point, const dvec3& direction, double room, double edge_length);
};

}  // namespace rad::repair
