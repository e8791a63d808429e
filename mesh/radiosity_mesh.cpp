#include "mesh/radiosity_mesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/element_views.h"
#include "mesh/node_sectors.h"

namespace rad::mesh {
namespace {

void add_nodes(const ElementMesh& mesh, RadiosityMesh& result) {
  result.nodes.resize(mesh.node_count());
  for (NodeId node = 0; node < mesh.node_count(); ++node) {
    result.nodes[node].position = mesh.lattice().position(mesh.points()[mesh.point_of(node)]);
    result.nodes[node].element_size = std::numeric_limits<double>::infinity();
  }
}

void add_patches(const ElementMesh& mesh, RadiosityMesh& result) {
  for (PatchId id = 0; id < mesh.patch_count(); ++id) {
    const PatchSource& source = mesh.source(id);
    Patch patch{mesh.corners(id), source.material, source.normal, 0};
    const dvec3 first = result.nodes[patch.corners.node[0]].position;
    for (std::uint32_t i = 1; i + 1 < patch.corners.count; ++i) {
      const dvec3 a = result.nodes[patch.corners.node[i]].position - first;
      const dvec3 b = result.nodes[patch.corners.node[i + 1]].position - first;
      patch.area += glm::dot(glm::cross(a, b), patch.normal) / 2;
    }
    result.patches.push_back(patch);
  }
}

/// The corners at every node: those of node n from first[n] to first[n + 1], in the order of elements.
struct CornersByNode {
  std::vector<NodeCorner> corners;
  std::vector<std::size_t> first;

  [[nodiscard]] std::span<const NodeCorner> at(std::size_t node) const {
    return std::span(corners).subspan(first[node], first[node + 1] - first[node]);
  }
};

CornersByNode corners_by_node(const RadiosityMesh& result) {
  CornersByNode by_node;
  by_node.first.assign(result.nodes.size() + 1, 0);
  for (const Element& element : result.elements) {
    for (const NodeId node : element.corners.all()) ++by_node.first[node + 1];
  }
  for (std::size_t node = 0; node < result.nodes.size(); ++node) by_node.first[node + 1] += by_node.first[node];
  by_node.corners.resize(by_node.first.back());
  std::vector<std::size_t> next = by_node.first;
  for (const Element& element : result.elements) {
    const auto& [node, count] = element.corners;
    for (std::uint32_t i = 0; i < count; ++i) {
      by_node.corners[next[node[i]]++] = {node[(i + 1) % count], node[(i + count - 1) % count], element.patch};
    }
  }
  return by_node;
}

}  // namespace

RadiosityMesh radiosity_mesh(const ElementMesh& mesh) {
  RadiosityMesh result;
  result.tolerance = mesh.tolerance().length;
  result.pitch = mesh.lattice().pitch;
  add_nodes(mesh, result);
  add_patches(mesh, result);
  for (const ElementId leaf : mesh.leaves()) {
    const AnchoredPieces pieces = mesh.anchored(leaf);
    for (const Corners& piece : pieces.all()) result.elements.push_back({piece, mesh.patch_of(leaf)});
  }
  const CornersByNode by_node = corners_by_node(result);
  const SectorView sectors(mesh, result.nodes);
  tbb::parallel_for(NodeId{0}, static_cast<NodeId>(mesh.node_count()), [&](NodeId id) {
    const auto corners = by_node.at(id);
    Node& node = result.nodes[id];
    node.normal = sectors.normal(corners);
    node.inward = sectors.inward(id, corners);
    for (const NodeCorner& corner : corners) {
      node.element_size = std::min({node.element_size, glm::distance(node.position, result.nodes[corner.next].position),
                                    glm::distance(node.position, result.nodes[corner.previous].position)});
    }
  });
  return result;
}

std::vector<ElementId> leaves_of_elements(const ElementMesh& mesh) {
  std::vector<ElementId> leaf_of_element;
  for (const ElementId leaf : mesh.leaves()) {
    leaf_of_element.insert(leaf_of_element.end(), mesh.anchored(leaf).count, leaf);
  }
  return leaf_of_element;
}

}  // namespace rad::mesh
