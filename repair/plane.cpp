#include "repair/plane.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace rad::repair {

Plane::Plane(const dvec3& direction, const LatticePoint& through) : normal(glm::normalize(direction)) {
  offset = glm::dot(normal, geom::as_vector(through));
  axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  mirrored = normal[axis] < 0;
}

}  // namespace rad::repair
