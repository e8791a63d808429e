#include "geom/vec.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::geom {

double distance_to_segment(const dvec3& point, const dvec3& from, const dvec3& to) {
  const dvec3 along = to - from;
  const double squared_length = glm::dot(along, along);
  const double t = squared_length > 0 ? std::clamp(glm::dot(point - from, along) / squared_length, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + t * along);
}

}  // namespace rad::geom
