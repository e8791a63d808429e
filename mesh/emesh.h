// Emesh (paper 3.4.3): the initial subdivision of patches into elements, denser where shadows end.
#pragma once

#include <string>

#include "mesh/element_mesh.h"
#include "scene/scene.h"

namespace rad::mesh {

/// How elements that are crossed by the border of a shadow are found: by tracing the silhouettes of things (no raster
/// limits it), by the paper's hemi-cubes, or not at all.
enum class ShadowSearch : std::uint8_t { Silhouettes, Hemicube, None };

struct EmeshOptions {
  double longest_edge = 0;  ///< of elements, file units; above 0
  double shadow_edge =
      0;  ///< of those that a shadow's border or a contact crosses; nothing is marked where not above 0
  ShadowSearch search = ShadowSearch::Silhouettes;
  std::span<const scene::Material> materials;  ///< of the patches; empty: nothing emits
  std::size_t most_emitters = 16;              ///< faces that shadows are looked for from: those of most power
  std::uint32_t hemicube_resolution = 512;     ///< pixels along an edge of its top
  std::string dump_hemicube;                   ///< OpenEXR file for that of the first emitter; empty for none
};

struct EmeshOutcome {
  std::size_t shadow_lines = 0;  ///< pieces traced, or pixels between which the depth steps
  std::size_t marked = 0;        ///< elements divided because of them
  std::string problem;           ///< a file that could not be written
};

/// Divides leaves until none that can be divided has an edge longer than asked for. The same whatever the number of
/// threads.
EmeshOutcome emesh(ElementMesh& mesh, const EmeshOptions& options);

}  // namespace rad::mesh
