#include "geom/constrained_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>
#include <map>
#include <optional>
#include <utility>

namespace rad::geom {
namespace {

// On integers below 2^25 the filters of this kernel practically never fall through, and its answers are exact.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// Bridges to holes are inserted twice, which the plain No_constraint_intersection_tag takes for an intersection; this
// one refuses true crossings alike.
using Intersections = CGAL::No_constraint_intersection_requiring_constructions_tag;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, Intersections>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;

constexpr int kUnvisited = -1;

EdgeKey key_of(std::uint32_t a, std::uint32_t b) { return a < b ? EdgeKey{a, b} : EdgeKey{b, a}; }

// The neighbour of `from` that lies on the constraint towards `to`: vertices in between split a constraint.
VertexHandle next_along(const Triangulation& triangulation, VertexHandle from, VertexHandle to) {
  auto edge = triangulation.incident_edges(from);
  const auto first = edge;
  do {
    const VertexHandle neighbour = edge->first->vertex(Triangulation::ccw(edge->second)) == from
                                       ? edge->first->vertex(Triangulation::cw(edge->second))
                                       : edge->first->vertex(Triangulation::ccw(edge->second));
    if (neighbour == to) return to;
    if (!triangulation.is_infinite(neighbour) &&
        CGAL::orientation(from->point(), neighbour->point(), to->point()) == CGAL::COLLINEAR &&
        CGAL::collinear_are_strictly_ordered_along_line(from->point(), neighbour->point(), to->point())) {
      return neighbour;
    }
  } while (++edge != first);
  return to;
}

// How often the rings run along each edge of the triangulation: an odd number separates inside from outside.
std::map<EdgeKey, int> ring_use(const Triangulation& triangulation, std::span<const std::vector<std::uint32_t>> rings,
                                std::span<const VertexHandle> handles) {
  std::map<EdgeKey, int> use;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      VertexHandle here = handles[ring[i]];
      const VertexHandle end = handles[ring[(i + 1) % ring.size()]];
      while (here != end) {
        const VertexHandle next = next_along(triangulation, here, end);
        ++use[key_of(here->info(), next->info())];
        here = next;
      }
    }
  }
  return use;
}

int use_of(const std::map<EdgeKey, int>& use, const FaceHandle& face, int edge) {
  const auto found =
      use.find(key_of(face->vertex(Triangulation::cw(edge))->info(), face->vertex(Triangulation::ccw(edge))->info()));
  return found == use.end() ? 0 : found->second;
}

// Floods from the outside; info() becomes the parity of crossings.
void mark_parity(Triangulation& triangulation, const std::map<EdgeKey, int>& use) {
  for (FaceHandle face : triangulation.all_face_handles()) face->info() = kUnvisited;
  std::deque<FaceHandle> queue{triangulation.infinite_face()};
  queue.front()->info() = 0;
  while (!queue.empty()) {
    const FaceHandle face = queue.front();
    queue.pop_front();
    for (int edge = 0; edge < 3; ++edge) {
      const FaceHandle neighbour = face->neighbor(edge);
      if (neighbour->info() != kUnvisited) continue;
      const bool at_infinity = triangulation.is_infinite(face) && triangulation.is_infinite(neighbour);
      neighbour->info() = at_infinity ? 0 : (face->info() + use_of(use, face, edge)) % 2;
      queue.push_back(neighbour);
    }
  }
}

bool insert_rings(Triangulation& triangulation, std::span<const std::vector<std::uint32_t>> rings,
                  std::span<const VertexHandle> handles) {
  try {
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const VertexHandle a = handles[ring[i]], b = handles[ring[(i + 1) % ring.size()]];
        if (a != b) triangulation.insert_constraint(a, b);
      }
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  return true;
}

}  // namespace

std::vector<PolygonTriangle> triangulate_rings(std::span<const PlanarPoint> points,
                                               std::span<const std::vector<std::uint32_t>> rings) {
  Triangulation triangulation;
  std::vector<VertexHandle> handles(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    handles[i] = triangulation.insert({static_cast<double>(points[i].u), static_cast<double>(points[i].v)});
    handles[i]->info() = i;
  }
  std::vector<PolygonTriangle> triangles;
  if (triangulation.dimension() < 2 || !insert_rings(triangulation, rings, handles)) return triangles;
  const auto use = ring_use(triangulation, rings, handles);
  mark_parity(triangulation, use);
  for (FaceHandle face : triangulation.finite_face_handles()) {
    if (face->info() != 1) continue;
    PolygonTriangle triangle;
    for (int i = 0; i < 3; ++i) {
      triangle.corners[i] = face->vertex(i)->info();
      triangle.boundary[i] = use_of(use, face, Triangulation::cw(i)) > 0;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace rad::geom
