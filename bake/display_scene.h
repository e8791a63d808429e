// The display mesh as a scene, for the writers and the rules.
#pragma once

#include "geom/lattice.h"
#include "mesh/display_mesh.h"
#include "scene/scene.h"

namespace rad::bake {

/// A scene with a vertex for each display vertex, in file units, and a face for each display face, both in the same
/// order. Materials, objects, groups, unit and up axis are those of `origin`, the scene that was meshed. Faces refer to
/// one section of the source, the display mesh itself, by their index. No lattice is recorded: only the caller knows
/// its tolerance.
scene::Scene display_scene(const mesh::DisplayMesh& display, const geom::Lattice& lattice, const scene::Scene& origin);

}  // namespace rad::bake
