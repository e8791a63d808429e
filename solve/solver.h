// The solution phase: progressive refinement over the nodes of an element mesh (paper section 4, [BAUM89]).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "mesh/element_mesh.h"
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

/// Adaptive refinement (paper 3.4.3 and 4).
struct RefineOptions {
  std::uint32_t levels = 4;       ///< times that elements of the given mesh are divided at most; 0 for not at all
  double shortest_edge = 0;       ///< elements stay whose children would have a longest edge below it, file units
  std::size_t most_elements = 0;  ///< leaves in the end, about; 0 for any number
  double bend = 0.02;             ///< of the radiosity at a centre from the mean of the corners, as a share
  double contrast = 0.9;          ///< of the radiosities at the corners of an element, as a share of the largest
  /// Patches whose elements come too near to others; empty for a mesh that is not judged.
  std::function<std::vector<mesh::PatchId>(const mesh::ElementMesh&)> at_fault;
};

/// As above, on the leaves of `elements`. Where the solution on them bends or steps more than the options say, they are
/// divided, level by level, the roughest where there would be too many, and the new nodes get their values by a replay
/// of all shots. Patches at fault are not divided. A solve that was stopped is not refined; one that is stopped while
/// it refines keeps the levels that are whole, with field.complete true, as the light is all shot.
mesh::RadiosityField solve(mesh::ElementMesh& elements, std::span<const scene::Material> materials,
                           const SolveOptions& options, const RefineOptions& refine, Progress& progress);

}  // namespace rad::solve
