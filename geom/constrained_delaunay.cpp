#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

#include "geom/planar_mesh.h"

namespace rad::geom {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Intersections = CGAL::No_constraint_intersection_requiring_constructions_tag;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, Intersections>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;

class Builder {
 public:
  Builder(std::span<const PlanarPoint> points, std::span<const std::array<std::uint32_t, 2>> edges)
      : points_(points), edges_(edges), representative_(points.size()), handles_(points.size()) {}

  PlanarMesh build() {
    find_coinciding();
    insert_points();
    if (triangulation_.dimension() < 2) return std::move(mesh_);
    insert_edges();
    take_triangles();
    return std::move(mesh_);
  }

 private:
  void find_coinciding() {
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return std::tie(points_[a], a) < std::tie(points_[b], b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && points_[order[i]] == points_[order[i - 1]];
      representative_[order[i]] = same ? representative_[order[i - 1]] : order[i];
      if (same) mesh_.conflicts.coinciding.push_back({representative_[order[i]], order[i]});
    }
  }

  void insert_points() {
    std::vector<Kernel::Point_2> places(points_.size());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      places[i] = {static_cast<double>(points_[i].u), static_cast<double>(points_[i].v)};
      if (representative_[i] == i) order.push_back(i);
    }
    const auto map = CGAL::make_property_map(places);
    CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map),
                       CGAL::Hilbert_sort_median_policy());
    FaceHandle hint;
    for (const std::size_t i : order) {
      const VertexHandle vertex = triangulation_.insert(places[i], hint);
      vertex->info() = static_cast<std::uint32_t>(i);
      hint = vertex->face();
      handles_[i] = vertex;
    }
  }

  void insert_edges() {
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      const VertexHandle a = handles_[representative_[edges_[edge][0]]];
      const VertexHandle b = handles_[representative_[edges_[edge][1]]];
      if (a == b) continue;
      try {
        triangulation_.insert_constraint(a, b);
      } catch (const Triangulation::Intersection_of_constraints_exception&) {
        mesh_.conflicts.crossing.push_back(edge);
        continue;
      }
      FaceHandle face;
      int index = 0;
      if (!triangulation_.is_edge(a, b, face, index)) note_point_on(edge);
    }
  }

  // Rare, so a walk over all points is good enough.
  void note_point_on(std::uint32_t edge) {
    const PlanarPoint a = points_[edges_[edge][0]], b = points_[edges_[edge][1]];
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const PlanarPoint p = points_[i];
      if (p == a || p == b || orient2d(a, b, p) != Sign::Zero) continue;
      const auto along = (p.u - a.u) * (b.u - a.u) + (p.v - a.v) * (b.v - a.v);
      const auto back = (p.u - b.u) * (a.u - b.u) + (p.v - b.v) * (a.v - b.v);
      if (along > 0 && back > 0) mesh_.conflicts.point_on_edge.push_back({edge, i});
    }
  }

  void take_triangles() {
    for (const FaceHandle face : triangulation_.all_face_handles()) face->info() = kNoTriangle;
    std::uint32_t count = 0;
    for (const FaceHandle face : triangulation_.finite_face_handles()) face->info() = count++;
    mesh_.triangles.reserve(count);
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      PlanarTriangle triangle;
      for (int i = 0; i < 3; ++i) {
        triangle.corner[i] = face->vertex(i)->info();
        const int opposite = Triangulation::cw(i);  // of the edge from corner i to i+1
        triangle.neighbour[i] = face->neighbor(opposite)->info();
        triangle.constrained[i] = face->is_constrained(opposite);
      }
      mesh_.triangles.push_back(triangle);
    }
  }

  std::span<const PlanarPoint> points_;
  std::span<const std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> representative_;
  std::vector<VertexHandle> handles_;
  Triangulation triangulation_;
  PlanarMesh mesh_;
};

}  // namespace

PlanarMesh constrained_delaunay(std::span<const PlanarPoint> points,
                                std::span<const std::array<std::uint32_t, 2>> edges) {
  return Builder(points, edges).build();
}

}  // namespace rad::geom
