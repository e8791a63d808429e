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

}  // namespace rad::geom
