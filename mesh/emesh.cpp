#include "mesh/emesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geom/predicates.h"
#include "mesh/crossed_leaves.h"
#include "mesh/hemicube.h"
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

/// The candidates that are leaves, longer than the limit and, where marks are given, marked.
std::vector<ElementId> too_long(const ElementMesh& mesh, const std::vector<ElementId>& candidates, double limit,
                                const std::vector<std::uint8_t>* marked) {
  std::vector<std::uint8_t> chosen(candidates.size(), 0);
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    const ElementId element = candidates[i];
    if (marked != nullptr && (*marked)[element] == 0) return;
    chosen[i] = mesh.is_leaf(element) && longest_edge_of(mesh, element) > limit ? 1 : 0;
  });
  std::vector<ElementId> found;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (chosen[i] != 0) found.push_back(candidates[i]);
  }
  return found;
}

void divide_evenly(ElementMesh& mesh, double limit) {
  std::vector<ElementId> candidates = mesh.leaves();
  while (true) {
    const std::size_t before = mesh.element_count();
    mesh.refine(too_long(mesh, candidates, limit, nullptr));
    if (mesh.element_count() == before) return;
    // Leaves that stayed could not be divided, or were short enough, unless a neighbour divided them: new ids all.
    candidates.resize(mesh.element_count() - before);
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i] = static_cast<ElementId>(before + i);
  }
}

class ShadowMarker {
 public:
  ShadowMarker(ElementMesh& mesh, const EmeshOptions& options)
      : mesh_(mesh),
        options_(options),
        limit_(options.shadow_edge / mesh.lattice().pitch + kLengthRounding),
        lights_(light_samples(mesh, options.materials, options.most_emitters)) {}

  EmeshOutcome run() {
    if (lights_.empty()) return outcome_;
    const PatchRays rays(mesh_);
    if (options_.search == ShadowSearch::Silhouettes) lines_ = shadow_lines(mesh_, rays, lights_, limit_);
    outcome_.shadow_lines = lines_.size();
    if (!options_.dump_hemicube.empty()) {
      const Hemicube cube = hemicube(mesh_, rays, lights_.front(), options_.hemicube_resolution);
      outcome_.problem = write_hemicube(cube, options_.dump_hemicube);
    }
    // Leaves that stay although they are marked could not be divided.
    for (std::size_t before = 0; before != mesh_.element_count();) {
      before = mesh_.element_count();
      const std::vector<std::uint8_t> marked = marks(rays);
      const std::vector<ElementId> chosen = too_long(mesh_, mesh_.leaves(), limit_, &marked);
      mesh_.refine(chosen);
      if (before != mesh_.element_count()) outcome_.marked += chosen.size();
    }
    return outcome_;
  }

 private:
  [[nodiscard]] std::vector<std::uint8_t> marks(const PatchRays& rays) const {
    std::vector<std::uint8_t> marked(mesh_.element_count(), 0);
    mark_at_contacts(mesh_, marked);
    if (options_.search == ShadowSearch::Silhouettes) {
      mark_crossed(mesh_, lines_, static_cast<double>(mesh_.tolerance().pitches), marked);
    } else {
      for (const LightSample& light : lights_) {
        mark_steps(hemicube(mesh_, rays, light, options_.hemicube_resolution), marked);
      }
    }
    return marked;
  }

  ElementMesh& mesh_;
  const EmeshOptions& options_;
  double limit_;
  std::vector<LightSample> lights_;
  std::vector<ShadowLine> lines_;
  EmeshOutcome outcome_;
};

}  // namespace

EmeshOutcome emesh(ElementMesh& mesh, const EmeshOptions& options) {
  divide_evenly(mesh, options.longest_edge / mesh.lattice().pitch + kLengthRounding);
  if (options.search == ShadowSearch::None || !(options.shadow_edge > 0)) return {};
  return ShadowMarker(mesh, options).run();
}

}  // namespace rad::mesh
