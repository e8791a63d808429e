// Pmesh (paper 3.4.1): a conforming model divided into patches.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "mesh/face_patches.h"
#include "mesh/patch_memory.h"
#include "mesh/patch_mesh.h"
#include "scene/conforming_model.h"

namespace rad::mesh {

/// How large patches become. Faces of materials that emit get `emitter_share` of the length.
struct PatchOptions {
  double longest_edge = 0;                     ///< l_max, file units; default_patch_length where it is not above 0
  double emitter_share = 0.5;                  ///< above 0, at most 1
  std::span<const scene::Material> materials;  ///< of the model's faces; empty: nothing emits
  std::size_t most_patches = 4'000'000;        ///< more are refused
  PatchMethod method = PatchMethod::Grid;
  std::vector<double> longest_of_face;  ///< per face of the model, file units; empty, or not above 0: longest_edge
  /// Faces of the model, ascending, that stay as the triangles of their triangulation: where they come so near to
  /// others that any division would be at fault.
  std::vector<std::uint32_t> whole_faces;
};

/// The mesh, or why there is none.
struct PatchOutcome {
  std::optional<PatchMesh> mesh;
  std::string problem;
};

/// Divides every face into patches with edges of at most the longest edge, up to rounding to the lattice; near short
/// edges and in narrow places they are smaller, with a gradual change of size (PatchMethod::Graded). Longer ones
/// remain only where dividing them would bring points nearer to each other or to an edge than the weld distance
/// 1.16 T: in needle tips. The same whatever the number of threads.
PatchOutcome pmesh(const scene::ConformingModel& model, const PatchOptions& options);
/// The same, sooner for faces that a call with this memory has met before: where a model is meshed anew because of a
/// few of its faces.
PatchOutcome pmesh(const scene::ConformingModel& model, const PatchOptions& options, PatchMemory& memory);

/// The patch length with which the model gets about 800 patches plus what its small faces need; at least 4 T.
/// File units; 4 T for a model without area.
double default_patch_length(const scene::ConformingModel& model);

}  // namespace rad::mesh
