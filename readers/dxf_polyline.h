// POLYLINE with its VERTEX records: polyface meshes, polygon meshes and outlines with thickness.
#pragma once

#include "readers/dxf_surfaces.h"

namespace rad::readers::dxf {

/// Reads the vertices that follow `head` in `groups`, up to and with SEQEND. Faces are added where `visible`.
void read_polyline(const Entity& head, Groups& groups, bool visible, Surfaces& surfaces, scene::ReadIssues& issues);

/// MESH: the faces of its cage. Subdivision and creases are counted as left out.
void add_mesh(const Entity& entity, Surfaces& surfaces);

}  // namespace rad::readers::dxf
