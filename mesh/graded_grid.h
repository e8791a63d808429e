// The grid over a face with boxes halved again and again where its outline is finely divided: a balanced quadtree whose
// largest boxes are those of the paper's grid.
#pragma once

#include "mesh/box_grid.h"

namespace rad::mesh {

/// Boxes near an edge of the outline are about as large as the edge is long, and neighbours, also over corners, differ
/// by one halving at most. Corners and boxes are left out as box_grid() does, by the size of the smallest box at a
/// corner; boxes with the corner of a smaller one in an edge are left out too.
/// `least_size` in pitches: boxes are not halved below it, and the outline keeps 0.6 of it from the sides of boxes.
BoxGrid graded_grid(const GridLines& lines, const GridObstacles& obstacles, double least_size);

}  // namespace rad::mesh
