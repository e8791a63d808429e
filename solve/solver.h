// The solution phase: progressive refinement over the nodes of an element mesh (paper section 4, [BAUM89]).
#pragma once

#include <cstddef>
#include <span>

#include "mesh/radiosity_field.h"
#include "mesh/radiosity_mesh.h"
#include "scene/scene.h"
#include "solve/progress.h"

namespace rad::solve {

struct SolveOptions {
  double unshot_limit = 1e-3;                         ///< share of the emitted power, every channel; ends the solve
  std::size_t shot_limit = 0;                         ///< ends the solve too; 0 for none
  std::size_t coupling_bytes = std::size_t{3} << 30;  ///< memory for form factors that are kept
  double metres_per_unit = 1;                         ///< of the mesh; only the energies depend on it
};

/// Radiosity at every node. The patches with the most unshot power shoot it to all nodes, again and again, until the
/// limit, the shot limit (field.complete is false then) or a stop by `progress` (likewise).
///
/// `materials` has one for each id in the patches; none of them has a light_problem. Every node of an element lies on
/// the surface of its patch, and the elements of each patch cover it. The same bits for any number of threads. Throws
/// std::runtime_error where the ray tracer cannot be set up, std::bad_alloc.
mesh::RadiosityField solve(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials,
                           const SolveOptions& options, Progress& progress);

}  // namespace rad::solve
