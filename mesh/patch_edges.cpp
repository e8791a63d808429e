#include "mesh/patch_edges.h"

#include <algorithm>
#include <tuple>

namespace rad::mesh {
namespace {

struct Use {
  std::uint32_t low, high;
  PatchId patch;
  std::uint8_t edge;
  bool forward;
};

std::vector<Use> uses_of(const ElementMesh& mesh) {
  std::vector<Use> uses;
  for (PatchId patch = 0; patch < mesh.patch_count(); ++patch) {
    const Corners corners = mesh.corners(patch);
    for (std::uint32_t i = 0; i < corners.count; ++i) {
      const std::uint32_t a = mesh.point_of(corners.node[i]), b = mesh.point_of(corners.node[(i + 1) % corners.count]);
      uses.push_back({std::min(a, b), std::max(a, b), patch, static_cast<std::uint8_t>(i), a < b});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.patch) < std::tie(b.low, b.high, b.patch);
  });
  return uses;
}

}  // namespace

std::vector<PatchEdge> crease_edges(const ElementMesh& mesh) {
  const std::vector<Use> uses = uses_of(mesh);
  std::vector<PatchEdge> edges;
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].low == uses[first].low && uses[last].high == uses[first].high) ++last;
    const bool pair = last - first == 2;
    const bool one_face = pair && mesh.source(uses[first].patch).face == mesh.source(uses[first + 1].patch).face;
    if (one_face && uses[first].forward != uses[first + 1].forward) continue;
    PatchEdge edge{
        {uses[first].low, uses[first].high}, {}, {}, 0, pair && uses[first].forward == uses[first + 1].forward};
    for (std::size_t i = first; i < last && edge.count < PatchEdge::kMost; ++i) {
      edge.patch[edge.count] = uses[i].patch;
      edge.edge[edge.count++] = uses[i].edge;
    }
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace rad::mesh
