// A radiosity field read at points: Gouraud in triangles, bilinear in quadrilaterals.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "mesh/radiosity_field.h"
#include "mesh/radiosity_mesh.h"

namespace rad::tests {

using geom::dvec3;

/// Shares of the four corners at a point in the plane of a convex quadrilateral, by Newton steps; nothing outside it.
inline std::optional<std::array<double, 4>> quadrilateral_shares(const std::array<dvec3, 4>& corner,
                                                                 const dvec3& point) {
  double u = 0.5, v = 0.5;
  for (int step = 0; step < 30; ++step) {
    const dvec3 at =
        corner[0] * ((1 - u) * (1 - v)) + corner[1] * (u * (1 - v)) + corner[2] * (u * v) + corner[3] * ((1 - u) * v);
    const dvec3 along = (corner[1] - corner[0]) * (1 - v) + (corner[2] - corner[3]) * v;
    const dvec3 up = (corner[3] - corner[0]) * (1 - u) + (corner[2] - corner[1]) * u;
    const dvec3 left = point - at;
    const double aa = glm::dot(along, along), uu = glm::dot(up, up), au = glm::dot(along, up);
    const double determinant = aa * uu - au * au;
    const double du = (glm::dot(left, along) * uu - glm::dot(left, up) * au) / determinant;
    const double dv = (glm::dot(left, up) * aa - glm::dot(left, along) * au) / determinant;
    u += du;
    v += dv;
    if (std::abs(du) + std::abs(dv) < 1e-13) break;
  }
  const double margin = 1e-7;
  if (!(u >= -margin && u <= 1 + margin && v >= -margin && v <= 1 + margin)) return std::nullopt;
  return std::array{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

/// Shares of the three corners at a point in the plane of a triangle; nothing outside it.
inline std::optional<std::array<double, 4>> triangle_shares(const std::array<dvec3, 3>& corner, const dvec3& point) {
  const dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0], q = point - corner[0];
  const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b), determinant = aa * bb - ab * ab;
  const double s = (glm::dot(q, a) * bb - glm::dot(q, b) * ab) / determinant;
  const double t = (glm::dot(q, b) * aa - glm::dot(q, a) * ab) / determinant;
  const double margin = 1e-7;
  if (s < -margin || t < -margin || s + t > 1 + margin) return std::nullopt;
  return std::array{1 - s - t, s, t, 0.0};
}

/// Mean of the values in all elements of this normal that hold the point; nothing where there is none.
inline std::optional<dvec3> radiosity_at(const mesh::RadiosityMesh& mesh, const mesh::RadiosityField& field,
                                         const dvec3& point, const dvec3& normal, double plane_distance) {
  dvec3 sum(0);
  int found = 0;
  for (const mesh::Element& element : mesh.elements) {
    const auto node = element.corners.node;
    const auto at = [&](int i) { return mesh.nodes[node[i]].position; };
    const dvec3 own = mesh.patches[element.patch].normal;
    if (glm::dot(own, normal) < 0.99 || std::abs(glm::dot(own, point - at(0))) > plane_distance) continue;
    const auto shares = element.corners.count == 3 ? triangle_shares({at(0), at(1), at(2)}, point)
                                                   : quadrilateral_shares({at(0), at(1), at(2), at(3)}, point);
    if (!shares) continue;
    for (std::uint32_t i = 0; i < element.corners.count; ++i) sum += field.radiosity[node[i]] * (*shares)[i];
    ++found;
  }
  if (found == 0) return std::nullopt;
  return sum / double(found);
}

}  // namespace rad::tests
