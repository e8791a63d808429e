#include "solve/solver.h"

#include "mesh/element_views.h"
#include "solve/refinement.h"
#include "solve/solution.h"

namespace rad::solve {
namespace {

mesh::RadiosityField field_of(const Solution& solution, const SolveOptions& options, bool complete) {
  mesh::RadiosityField field;
  field.radiosity = solution.shooting().radiosity();
  field.energy = solution.shooting().energy(options.metres_per_unit);
  field.shots = solution.shooting().shots();
  field.complete = complete;
  return field;
}

/// Rounds of dividing and judging; what is at fault after the last is not refined at all.
constexpr int kJudgings = 3;

void refine_solution(Solution& solution, mesh::ElementMesh& elements, std::vector<dvec3>& radiosity,
                     const RefineOptions& options, Progress& progress) {
  std::vector<bool> whole(elements.patch_count(), false);
  for (int round = 0; round < kJudgings; ++round) {
    mesh::ElementMesh refined = elements;
    std::vector<dvec3> values = radiosity;
    Refinement(solution, refined, options, whole).run(values, progress);
    const auto faults = options.at_fault ? options.at_fault(refined) : std::vector<mesh::PatchId>{};
    if (faults.empty()) {
      elements = std::move(refined);
      radiosity = std::move(values);
      return;
    }
    for (const mesh::PatchId patch : faults) whole[patch] = true;
  }
}

}  // namespace

mesh::RadiosityField solve(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                           const SolveOptions& options, Progress& progress) {
  Solution solution(mesh, materials, options);
  const bool complete = solution.run(progress);
  return field_of(solution, options, complete);
}

mesh::RadiosityField solve(mesh::ElementMesh& elements, std::span<const scene::Material> materials,
                           const SolveOptions& options, const RefineOptions& refine, Progress& progress) {
  const mesh::RadiosityMesh mesh = mesh::radiosity_mesh(elements);
  Solution solution(mesh, materials, options);
  const bool complete = solution.run(progress);
  mesh::RadiosityField field = field_of(solution, options, complete);
  if (complete && refine.levels > 0) refine_solution(solution, elements, field.radiosity, refine, progress);
  return field;
}

}  // namespace rad::solve
