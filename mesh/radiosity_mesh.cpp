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

// By node, then in the order of elements.
std::vector<NodeCorner> corners_by_node(const ElementMesh& mesh, const RadiosityMesh& result) {
  std::vector<NodeCorner> corners;
  for (const Element& element : result.elements) {
    const PatchSource& source = mesh.source(element.patch);
    const std::uint32_t count = element.corners.count;
    for (std::uint32_t i = 0; i < count; ++i) {
      corners.push_back({element.corners.node[i], element.corners.node[(i + 1) % count],
                         element.corners.node[(i + count - 1) % count], source.face, source.face_area, source.normal});
    }
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const NodeCorner& a, const NodeCorner& b) { return a.node < b.node; });
  return corners;
}

void describe(Node& node, std::span<const NodeCorner> corners, std::span<const Node> nodes) {
  node.normal = node_normal(corners);
  node.inward = inward_direction(corners, node.normal, nodes);
  for (const NodeCorner& corner : corners) {
    node.element_size = std::min({node.element_size, glm::distance(node.position, nodes[corner.next].position),
                                  glm::distance(node.position, nodes[corner.previous].position)});
  }
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
  const std::vector<NodeCorner> corners = corners_by_node(mesh, result);
  std::vector<std::size_t> first(mesh.node_count() + 1, 0);
  for (const NodeCorner& corner : corners) ++first[corner.node + 1];
  for (std::size_t node = 0; node < mesh.node_count(); ++node) first[node + 1] += first[node];
  tbb::parallel_for(std::size_t{0}, mesh.node_count(), [&](std::size_t node) {
    const std::span around = std::span(corners).subspan(first[node], first[node + 1] - first[node]);
    describe(result.nodes[node], around, result.nodes);
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
