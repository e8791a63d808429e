#include "mesh/emesh.h"

#include <cmath>

#include "geom/predicates.h"
#include "mesh/lengths.h"

namespace rad::mesh {
namespace {

double longest_edge_of(const ElementMesh& mesh, ElementId element) {
  const Corners own = mesh.corners(element);
  std::int64_t longest = 0;
  for (std::uint32_t i = 0; i < own.count; ++i) {
    longest = std::max(longest, geom::squared_distance(mesh.points()[mesh.point_of(own.node[i])],
                                                       mesh.points()[mesh.point_of(own.node[(i + 1) % own.count])]));
  }
  return std::sqrt(static_cast<double>(longest));
}

}  // namespace

void emesh(ElementMesh& mesh, double longest_edge) {
  const double limit = longest_edge / mesh.lattice().pitch + kLengthRounding;
  std::vector<ElementId> candidates = mesh.leaves();
  while (true) {
    std::vector<ElementId> long_ones;
    for (const ElementId element : candidates) {
      if (mesh.is_leaf(element) && longest_edge_of(mesh, element) > limit) long_ones.push_back(element);
    }
    const std::size_t before = mesh.element_count();
    mesh.refine(long_ones);
    if (mesh.element_count() == before) return;
    // Leaves that stayed could not be divided, or were short enough, unless a neighbour divided them: new ids all.
    candidates.resize(mesh.element_count() - before);
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i] = static_cast<ElementId>(before + i);
  }
}

}  // namespace rad::mesh
