#include "mesh/statistics.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "geom/planar_shape.h"

namespace rad::mesh {
namespace {

using geom::dvec3;

std::vector<dvec3> corners_of(const PatchMesh& mesh, PatchConnectivity::FaceHandle patch) {
  std::vector<dvec3> corners;
  for (const auto vertex : mesh.patches.fv_range(patch)) {
    corners.push_back(geom::as_vector(mesh.points[mesh.patches.data(vertex).lattice_point]));
  }
  return corners;
}

double shape_of(std::span<const dvec3> corners, const dvec3& normal) {
  const dvec3 along = glm::normalize(corners[1] - corners[0]), across = glm::cross(normal, along);
  std::vector<geom::PlanePoint> flat;
  for (const dvec3& corner : corners) {
    flat.push_back({glm::dot(corner - corners[0], along), glm::dot(corner - corners[0], across)});
  }
  return geom::scaled_shape(flat);
}

ShapePercentiles percentiles(std::vector<double> shapes) {
  if (shapes.empty()) return {};
  std::sort(shapes.begin(), shapes.end());
  const auto at = [&](std::size_t percent) { return shapes[(shapes.size() - 1) * percent / 100]; };
  return {shapes.front(), at(1), at(5), at(50)};
}

}  // namespace

PatchStatistics patch_statistics(const PatchMesh& mesh) {
  PatchStatistics statistics;
  std::vector<double> shapes, blunt;
  double longest = 0;
  for (const PatchedFace& face : mesh.faces) statistics.area += face.area;
  for (const auto patch : mesh.patches.faces()) {
    const std::vector<dvec3> corners = corners_of(mesh, patch);
    ++(corners.size() == 3 ? statistics.triangles : statistics.quads);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % corners.size()]));
    }
    const PatchedFace& face = mesh.faces[mesh.patches.data(patch).face];
    shapes.push_back(shape_of(corners, face.normal));
    ++statistics.histogram[std::min<std::size_t>(9, static_cast<std::size_t>(10 * shapes.back()))];
    if (face.least_corner_deg >= kBluntDegrees) blunt.push_back(shapes.back());
  }
  statistics.longest_edge = longest * mesh.lattice.pitch;
  statistics.shape = percentiles(std::move(shapes));
  statistics.blunt_patches = blunt.size();
  statistics.blunt_shape = percentiles(std::move(blunt));
  return statistics;
}

ElementStatistics element_statistics(const ElementMesh& mesh) {
  ElementStatistics statistics;
  statistics.nodes = mesh.node_count();
  for (const ElementId leaf : mesh.leaves()) {
    ++statistics.leaves;
    statistics.deepest_level = std::max<std::size_t>(statistics.deepest_level, mesh.level(leaf));
  }
  if (statistics.leaves > 0) {
    statistics.bytes_per_leaf = static_cast<double>(mesh.memory_bytes()) / static_cast<double>(statistics.leaves);
  }
  return statistics;
}

}  // namespace rad::mesh
