#include "geom/triangle_column.h"

#include <glm/geometric.hpp>

namespace rad::geom {

TriangleColumn::TriangleColumn(const std::array<LatticePoint, 3>& corners) {
  const std::array<dvec3, 3> v{as_vector(corners[0]), as_vector(corners[1]), as_vector(corners[2])};
  normal_ = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
  offset_ = glm::dot(normal_, v[0]);
  for (int edge = 0; edge < 3; ++edge) {
    inward_[edge] = glm::cross(normal_, glm::normalize(v[(edge + 1) % 3] - v[edge]));
    inward_offset_[edge] = glm::dot(inward_[edge], v[edge]);
  }
}

bool TriangleColumn::over_or_under(const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                   double distance) const {
  bool over = true, under = true;
  for (int i = 0; i < 3; ++i) {
    if (shared[i] != kNotShared) continue;
    const double at = height(other[i]);
    over = over && at > distance;
    under = under && at < -distance;
  }
  return over || under;
}

bool TriangleColumn::beyond_edge(int edge, const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                 double distance) const {
  const dvec3& inward = inward_[edge];
  for (int i = 0; i < 3; ++i) {
    const bool on_edge = shared[i] == edge || shared[i] == (edge + 1) % 3;
    if (on_edge) continue;
    // Written so that a triangle without area, whose planes are not numbers, proves nothing.
    if (!(inward.x * other[i].x + inward.y * other[i].y + inward.z * other[i].z - inward_offset_[edge] < -distance)) {
      return false;
    }
  }
  return true;
}

bool TriangleColumn::keeps_out(const std::array<dvec3, 3>& other, const SharedCorners& shared, double distance,
                               bool beyond_edges_only) const {
  return (!beyond_edges_only && over_or_under(other, shared, distance)) || beyond_edge(0, other, shared, distance) ||
         beyond_edge(1, other, shared, distance) || beyond_edge(2, other, shared, distance);
}

}  // namespace rad::geom
