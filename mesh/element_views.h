// An element mesh as others read it: what a solver works on, and what is written and shown.
#pragma once

#include <vector>

#include "mesh/display_mesh.h"
#include "mesh/element_mesh.h"
#include "mesh/radiosity_mesh.h"

namespace rad::mesh {

/// Nodes and patches have the ids of the element mesh; elements are the anchored pieces of its leaves, in the order of
/// leaves().
RadiosityMesh radiosity_mesh(const ElementMesh& mesh);

/// For every element of radiosity_mesh() the leaf that it is a piece of.
std::vector<ElementId> leaves_of_elements(const ElementMesh& mesh);

/// Anchored leaves, ziplocked across surfaces (paper 2.3): no vertex lies inside an edge of another face. The first
/// vertices are the nodes, by id.
DisplayMesh display_mesh(const ElementMesh& mesh);

}  // namespace rad::mesh
