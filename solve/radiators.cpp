#include "solve/radiators.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

std::array<double, 4> corner_areas(std::span<const dvec3> corners) {
  std::array<double, 4> areas{};
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 ahead = corners[(i + 1) % count] - corners[i];
    const dvec3 back = corners[(i + count - 1) % count] - corners[i];
    areas[i] = glm::length(glm::cross(ahead, back));
  }
  return areas;
}

double area_of(std::span<const dvec3> corners) {
  dvec3 twice{0, 0, 0};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    twice += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return glm::length(twice) / 2;
}

void place(Radiator& radiator, const Stratum& stratum) {
  radiator.centre = stratum.centre();
  for (const dvec3& corner : stratum.all()) {
    radiator.radius = std::max(radiator.radius, glm::length(corner - radiator.centre));
  }
}

/// Adds an element of the radiator that is last in `radiators`; `local_of[node]` is kept by the caller for one patch.
void add_element(Radiators& radiators, const mesh::Element& element, const mesh::RadiosityMesh& mesh,
                 std::vector<std::uint32_t>& local_of, std::vector<mesh::PatchId>& local_in) {
  Radiator& radiator = radiators.patch[element.patch];
  const Stratum stratum = stratum_of(element.corners, mesh);
  const double area = area_of(stratum.all());
  const std::array<double, 4> shares = mean_shares(stratum.all());
  std::array<std::uint32_t, 4>& corner = radiators.corner.emplace_back();
  for (std::uint32_t i = 0; i < element.corners.count; ++i) {
    const mesh::NodeId node = element.corners.node[i];
    if (local_in[node] != element.patch) {
      local_in[node] = element.patch;
      local_of[node] = radiator.local_count++;
      radiators.local_node.push_back(node);
      radiators.local_share.push_back(0);
    }
    corner[i] = local_of[node];
    radiators.local_share[radiator.first_local + corner[i]] += area * shares[i];
  }
  radiator.area += area;
  ++radiator.element_count;
}

}  // namespace

std::array<double, 4> mean_shares(std::span<const dvec3> corners) {
  if (corners.size() == 3) return {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
  // The Jacobian of the bilinear map is bilinear too, with the corner areas at its corners; the integral of the product of
  // two of the four shape functions over the unit square is 1/9, 1/18 or 1/36 for the same corner, its neighbours, the
  // opposite one.
  const std::array<double, 4> areas = corner_areas(corners);
  std::array<double, 4> shares{};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    shares[i] = 4 * areas[i] + 2 * areas[(i + 1) % 4] + 2 * areas[(i + 3) % 4] + areas[(i + 2) % 4];
    sum += shares[i];
  }
  if (!(sum > 0)) return {0.25, 0.25, 0.25, 0.25};
  for (double& share : shares) share /= sum;
  return shares;
}

Stratum stratum_of(const mesh::Corners& corners, const mesh::RadiosityMesh& mesh) {
  std::array<dvec3, 4> points;
  for (std::uint32_t i = 0; i < corners.count; ++i) points[i] = mesh.nodes[corners.node[i]].position;
  return whole(std::span(points).first(corners.count));
}

Radiators radiators_of(const mesh::RadiosityMesh& mesh) {
  Radiators radiators;
  radiators.patch.resize(mesh.patches.size());
  std::vector<std::uint32_t> local_of(mesh.nodes.size());
  std::vector<mesh::PatchId> local_in(mesh.nodes.size(), static_cast<mesh::PatchId>(mesh.patches.size()));
  std::size_t element = 0;
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    Radiator& radiator = radiators.patch[patch];
    place(radiator, stratum_of(mesh.patches[patch].corners, mesh));
    radiator.first_local = static_cast<std::uint32_t>(radiators.local_node.size());
    radiator.first_element = static_cast<std::uint32_t>(element);
    while (element < mesh.elements.size() && mesh.elements[element].patch == patch) {
      add_element(radiators, mesh.elements[element++], mesh, local_of, local_in);
    }
    for (std::uint32_t i = 0; i < radiator.local_count; ++i) {
      radiators.local_share[radiator.first_local + i] /= radiator.area > 0 ? radiator.area : 1;
    }
  }
  return radiators;
}

}  // namespace rad::solve
