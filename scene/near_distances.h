// How near vertices are to other vertices and to edges: the distances in which noise and features show as two modes.
#pragma once

#include <vector>

#include "scene/lattice_model.h"

namespace rad::scene {

/// For each vertex of the lattice model the distance to the nearest other vertex, and to the nearest edge that it is no
/// end of, in file units; only distances of at most 1 % of the diagonal, and only what rounding to the lattice does not
/// make up: more than 2 pitches. Ascending. Parallel; O(n log n) where the density of the model varies slowly.
std::vector<double> near_distances(const Scene& scene, const LatticeModel& model);

}  // namespace rad::scene
