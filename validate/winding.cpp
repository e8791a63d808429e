#include "validate/winding.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace rad::validate {

double winding_number(const Context& context, std::span<const std::uint32_t> triangles, const dvec3& lattice_point) {
  double total = 0;
  for (const std::uint32_t index : triangles) {
    std::array<dvec3, 3> r;
    std::array<double, 3> length;
    for (int i = 0; i < 3; ++i) {
      const geom::LatticePoint& p = context.triangles.geometry[index].points[i];
      r[i] = dvec3(p.x, p.y, p.z) - lattice_point;
      length[i] = glm::length(r[i]);
    }
    // Van Oosterom and Strackee: tan(Ω/2) = det / (abc + (a·b)c + (b·c)a + (c·a)b).
    const double determinant = glm::dot(r[0], glm::cross(r[1], r[2]));
    const double denominator = length[0] * length[1] * length[2] + glm::dot(r[0], r[1]) * length[2] +
                               glm::dot(r[1], r[2]) * length[0] + glm::dot(r[2], r[0]) * length[1];
    total += 2 * std::atan2(determinant, denominator);
  }
  return total / (4 * std::numbers::pi);
}

}  // namespace rad::validate
