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

// How often the outline runs along each edge of the triangulation: an odd number separates inside from outside.
std::map<EdgeKey, int> outline_use(const Triangulation& triangulation, std::span<const PointEdge> outline,
                                   std::span<const VertexHandle> handles) {
  std::map<EdgeKey, int> use;
  for (const PointEdge& edge : outline) {
    VertexHandle here = handles[edge[0]];
    const VertexHandle end = handles[edge[1]];
    while (here != end) {
      const VertexHandle next = next_along(triangulation, here, end);
      ++use[key_of(here->info(), next->info())];
      here = next;
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

std::vector<VertexHandle> inserted(Triangulation& triangulation, std::span<const PlanarPoint> points) {
  std::vector<VertexHandle> handles(points.size());
  FaceHandle near;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    handles[i] = triangulation.insert({static_cast<double>(points[i].u), static_cast<double>(points[i].v)}, near);
    handles[i]->info() = i;
    near = handles[i]->face();
  }
  return handles;
}

bool insert_edges(Triangulation& triangulation, std::span<const PointEdge> edges,
                  std::span<const VertexHandle> handles) {
  try {
    for (const PointEdge& edge : edges) {
      if (handles[edge[0]] != handles[edge[1]]) triangulation.insert_constraint(handles[edge[0]], handles[edge[1]]);
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  return true;
}

}  // namespace

std::vector<PolygonTriangle> triangulate_region(std::span<const PlanarPoint> points, std::span<const PointEdge> outline,
                                                std::span<const PointEdge> inner) {
  Triangulation triangulation;
  const std::vector<VertexHandle> handles = inserted(triangulation, points);
  std::vector<PolygonTriangle> triangles;
  if (triangulation.dimension() < 2 || !insert_edges(triangulation, outline, handles) ||
      !insert_edges(triangulation, inner, handles)) {
    return triangles;
  }
  mark_parity(triangulation, outline_use(triangulation, outline, handles));
  for (FaceHandle face : triangulation.finite_face_handles()) {
    if (face->info() != 1) continue;
    PolygonTriangle triangle;
    for (int i = 0; i < 3; ++i) {
      triangle.corners[i] = face->vertex(i)->info();
      triangle.boundary[i] = face->is_constrained(Triangulation::cw(i));
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<PolygonTriangle> triangulate_rings(std::span<const PlanarPoint> points,
                                               std::span<const std::vector<std::uint32_t>> rings) {
  std::vector<PointEdge> outline;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) outline.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  return triangulate_region(points, outline, {});
}

}  // namespace rad::geom
