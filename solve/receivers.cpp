#include "solve/receivers.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

constexpr double kInwardTolerances = 4;
constexpr double kInwardElementShare = 1e-3;
constexpr double kLargestInwardElementShare = 0.25;
constexpr double kLiftPitches = 2;
constexpr double kLiftDiagonalShare = 0x1p-20;

double inward_distance(const mesh::Node& node, double tolerance) {
  const double wanted = std::max(kInwardTolerances * tolerance, kInwardElementShare * node.element_size);
  return std::min(wanted, kLargestInwardElementShare * node.element_size);
}

}  // namespace

Stratum stratum_of(const mesh::Corners& corners, const mesh::RadiosityMesh& mesh) {
  std::array<dvec3, 4> points;
  for (std::uint32_t i = 0; i < corners.count; ++i) points[i] = mesh.nodes[corners.node[i]].position;
  return whole(std::span(points).first(corners.count));
}

double lift_of(const mesh::RadiosityMesh& mesh) {
  if (mesh.nodes.empty()) return 0;
  dvec3 low = mesh.nodes.front().position;
  dvec3 high = low;
  for (const mesh::Node& node : mesh.nodes) {
    low = glm::min(low, node.position);
    high = glm::max(high, node.position);
  }
  return std::max(kLiftPitches * mesh.pitch, kLiftDiagonalShare * glm::length(high - low));
}

Receiver receiver_at(const mesh::Node& node, double tolerance, double lift) {
  const dvec3 inward = node.inward * inward_distance(node, tolerance);
  return {node.position + inward + node.normal * lift, node.normal};
}

std::vector<Receiver> receivers_of(const mesh::RadiosityMesh& mesh) {
  const double lift = lift_of(mesh);
  std::vector<Receiver> receivers;
  receivers.reserve(mesh.nodes.size() + mesh.elements.size());
  for (const mesh::Node& node : mesh.nodes) receivers.push_back(receiver_at(node, mesh.tolerance, lift));
  for (const mesh::Element& element : mesh.elements) {
    const dvec3& normal = mesh.patches[element.patch].normal;
    receivers.push_back({stratum_of(element.corners, mesh).centre() + normal * lift, normal});
  }
  std::vector<std::uint32_t> elements_of_patch(mesh.patches.size(), 0);
  for (const mesh::Element& element : mesh.elements) ++elements_of_patch[element.patch];
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    if (elements_of_patch[patch] == 1) continue;
    const dvec3& normal = mesh.patches[patch].normal;
    receivers.push_back({stratum_of(mesh.patches[patch].corners, mesh).centre() + normal * lift, normal});
  }
  return receivers;
}

}  // namespace rad::solve
