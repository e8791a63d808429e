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

/// Numbers the receivers of one patch after the other.
class LocalNumbers {
 public:
  explicit LocalNumbers(const mesh::RadiosityMesh& mesh)
      : local_(mesh.nodes.size()), patch_(mesh.nodes.size(), static_cast<mesh::PatchId>(mesh.patches.size())) {}

  std::uint32_t of(mesh::NodeId node, mesh::PatchId patch, Radiators& radiators) {
    if (patch_[node] != patch) {
      patch_[node] = patch;
      local_[node] = append(node, patch, radiators);
    }
    return local_[node];
  }

  static std::uint32_t append(ReceiverId receiver, mesh::PatchId patch, Radiators& radiators) {
    radiators.local_receiver.push_back(receiver);
    radiators.local_share.push_back(0);
    radiators.local_slope.push_back({0, 0});
    return radiators.patch[patch].local_count++;
  }

 private:
  std::vector<std::uint32_t> local_;
  std::vector<mesh::PatchId> patch_;  ///< for which `local_` holds
};

/// Determinant of the second moments, as a share of the product of the two, below which a patch has no slopes.
constexpr double kThinnest = 1e-9;

void add_element(Radiators& radiators, std::size_t index, const mesh::RadiosityMesh& mesh, LocalNumbers& numbers) {
  const mesh::Element& element = mesh.elements[index];
  const Stratum stratum = stratum_of(element.corners, mesh);
  const double area = area_of(stratum.all());
  const Shares shares = mean_shares(stratum.all());
  ElementLocals& locals = radiators.element.emplace_back();
  for (std::uint32_t i = 0; i < element.corners.count; ++i) {
    locals[i] = numbers.of(element.corners.node[i], element.patch, radiators);
  }
  locals[kCentreShare] = LocalNumbers::append(centre_of(mesh, index), element.patch, radiators);
  Radiator& radiator = radiators.patch[element.patch];
  for (std::size_t i = 0; i < shares.size(); ++i)
    radiators.local_share[radiator.first_local + locals[i]] += area * shares[i];
  for (const dvec3& a : stratum.all()) {
    for (const dvec3& b : stratum.all()) {
      radiator.element_radius = std::max(radiator.element_radius, glm::length(a - b) / 2);
    }
  }
  radiator.area += area;
  ++radiator.element_count;
}

/// Coordinates of points of the patch from its centroid, in radii.
void place(Radiator& radiator, const Stratum& stratum, const dvec3& normal) {
  radiator.centre = stratum.centre();
  for (const dvec3& corner : stratum.all()) {
    radiator.radius = std::max(radiator.radius, glm::length(corner - radiator.centre));
  }
  const dvec3 along = stratum.corner[1] - stratum.corner[0];
  const double length = glm::length(along) * radiator.radius;
  if (length > 0) radiator.axis = {along / length, glm::cross(normal, along) / length};
}

void finish_shares(Radiators& radiators, Radiator& radiator, std::span<const Receiver> receivers) {
  for (std::uint32_t i = 0; i < radiator.local_count; ++i) {
    double& share = radiators.local_share[radiator.first_local + i];
    share /= radiator.area > 0 ? radiator.area : 1;
    radiator.centroid += receivers[radiators.local_receiver[radiator.first_local + i]].position * share;
  }
}

/// Slopes by least squares: the inverse of the second moments times the first moments of the values.
void fit_slopes(Radiators& radiators, const Radiator& radiator, std::span<const Receiver> receivers) {
  std::vector<std::array<double, 2>> place;
  double uu = 0, uv = 0, vv = 0;
  for (std::uint32_t i = 0; i < radiator.local_count; ++i) {
    const auto& [u, v] = place.emplace_back(
        radiator.coordinates(receivers[radiators.local_receiver[radiator.first_local + i]].position));
    const double share = radiators.local_share[radiator.first_local + i];
    uu += share * u * u;
    uv += share * u * v;
    vv += share * v * v;
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > kThinnest * uu * vv)) return;
  for (std::uint32_t i = 0; i < radiator.local_count; ++i) {
    const auto& [u, v] = place[i];
    const double share = radiators.local_share[radiator.first_local + i] / determinant;
    radiators.local_slope[radiator.first_local + i] = {share * (vv * u - uv * v), share * (uu * v - uv * u)};
  }
}

}  // namespace

Shares mean_shares(std::span<const dvec3> corners) {
  if (corners.size() == 3) return {1.0 / 12, 1.0 / 12, 1.0 / 12, 0, 3.0 / 4};
  // The Jacobian of the bilinear map is bilinear too, with the corner areas at its corners; the integral of the product
  // of two of the four bilinear shapes over the unit square is 1/9, 1/18 or 1/36 for the same corner, its neighbours,
  // the opposite one. The bubble is even about the centre: its mean is 2/3 with any linear Jacobian.
  const std::array<double, 4> areas = corner_areas(corners);
  std::array<double, 4> bilinear{};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    bilinear[i] = 4 * areas[i] + 2 * areas[(i + 1) % 4] + 2 * areas[(i + 3) % 4] + areas[(i + 2) % 4];
    sum += bilinear[i];
  }
  Shares shares{};
  shares[kCentreShare] = 2.0 / 3;
  for (std::size_t i = 0; i < 4; ++i) shares[i] = (sum > 0 ? bilinear[i] / sum : 0.25) - 2.0 / 3 / 4;
  return shares;
}

Radiators radiators_of(const mesh::RadiosityMesh& mesh, std::span<const Receiver> receivers) {
  Radiators radiators;
  radiators.patch.resize(mesh.patches.size());
  LocalNumbers numbers(mesh);
  std::size_t element = 0;
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    Radiator& radiator = radiators.patch[patch];
    place(radiator, stratum_of(mesh.patches[patch].corners, mesh), mesh.patches[patch].normal);
    radiator.first_local = static_cast<std::uint32_t>(radiators.local_receiver.size());
    radiator.first_element = static_cast<std::uint32_t>(element);
    while (element < mesh.elements.size() && mesh.elements[element].patch == patch) {
      add_element(radiators, element++, mesh, numbers);
    }
    finish_shares(radiators, radiator, receivers);
    fit_slopes(radiators, radiator, receivers);
  }
  return radiators;
}

}  // namespace rad::solve
