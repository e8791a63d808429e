// CGAL's detector of self-intersections: the yardstick that travels between machines.
#pragma once

#include "scene/scene.h"

namespace rad::bench {

struct Yardstick {
  std::size_t pairs = 0;
  double cpu_seconds = 0;  ///< of Polygon_mesh_processing::self_intersections alone, sequential
};

/// Only triangles of the scene are looked at.
Yardstick cgal_self_intersections(const scene::Scene& scene);

/// User and system seconds of this process so far.
double cpu_seconds();

}  // namespace rad::bench
