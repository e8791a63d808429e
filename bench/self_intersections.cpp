#include "bench/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <sys/resource.h>

#include <iterator>

namespace rad::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Yardstick cgal_self_intersections(const scene::Scene& scene) {
  Mesh mesh;
  for (const scene::dvec3& p : scene.vertices) mesh.add_vertex({p.x, p.y, p.z});
  for (const scene::Face& face : scene.faces) {
    const auto corners = scene.corners_of(scene.loops[face.first_loop]);
    if (corners.size() != 3) continue;
    using Vertex = Mesh::Vertex_index;
    mesh.add_face(Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2]));
  }
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  const double start = cpu_seconds();
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return {pairs.size(), cpu_seconds() - start};
}

}  // namespace rad::bench
