// Emesh (paper 3.4.3): the initial subdivision of patches into elements.
#pragma once

#include "mesh/element_mesh.h"

namespace rad::mesh {

/// Divides leaves until none that can be divided has an edge longer than `longest_edge` (file units, above 0).
void emesh(ElementMesh& mesh, double longest_edge);

}  // namespace rad::mesh
