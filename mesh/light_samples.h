// Points of the emitters from which shadows are looked for.
#pragma once

#include <span>
#include <vector>

#include "mesh/element_mesh.h"
#include "scene/scene.h"

namespace rad::mesh {

/// Lattice coordinates, in front of an emitting face.
struct LightSample {
  dvec3 place;
  dvec3 normal;  ///< of the face; unit length
};

/// Of each of the `most_emitters` faces that emit most power the middle, and the points that reach out farthest along
/// four directions: the middle of the penumbra, and its limits.
std::vector<LightSample> light_samples(const ElementMesh& mesh, std::span<const scene::Material> materials,
                                       std::size_t most_emitters);

}  // namespace rad::mesh
