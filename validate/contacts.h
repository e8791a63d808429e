// Where faces meet within T without saying so: the one search that the rules of 2a, 2b, 2c and 3a read.
#pragma once

#include <memory>
#include <vector>

#include "geom/box_tree.h"
#include "geom/tolerance.h"
#include "geom/triangle_contact.h"
#include "validate/face_triangles.h"

namespace rad::validate {

/// All contacts of one kind between two faces, a < b.
struct FaceContact {
  FaceId a = 0;
  FaceId b = 0;
  geom::ContactKind kind = geom::ContactKind::None;
  bool same_facing = true;               ///< of an Overlap
  double size = 0;                       ///< total: length in pitches, or area in pitches²
  std::array<geom::dvec3, 2> segment{};  ///< lattice coordinates; from the first to the last meeting point
};

/// A vertex within T of the open inside of an edge that it does not belong to: more than T from both ends.
struct VertexOnEdge {
  std::array<PointId, 2> edge{};  ///< ascending
  PointId vertex = 0;
  FaceId edge_face = 0;
  FaceId vertex_face = 0;

  friend constexpr auto operator<=>(const VertexOnEdge&, const VertexOnEdge&) = default;
};

/// Two different lattice vertices within T of each other, on faces that come that near.
struct NearVertices {
  PointId a = 0;  ///< a < b
  PointId b = 0;
  FaceId a_face = 0;
  FaceId b_face = 0;

  friend constexpr auto operator<=>(const NearVertices&, const NearVertices&) = default;
};

struct Contacts {
  std::vector<FaceContact> faces;               ///< by (a, b, kind)
  std::vector<VertexOnEdge> vertices_on_edges;  ///< ascending, unique
  std::vector<NearVertices> near_vertices;      ///< ascending, unique
  bool truncated = false;                       ///< a part of the scene was too dense to be searched to the end
  std::shared_ptr<const geom::BoxTree> tree;    ///< of the triangles, their boxes inflated by at least T/2
};

/// Caps for scenes in which almost every triangle meets almost every other. Each block of 1024 triangles has its equal
/// share, or `least_…` where that is more, so that what is left out does not depend on the number of threads. Real
/// models stay below a hundredth of them.
struct SearchLimits {
  std::size_t pairs = 1'000'000'000;  ///< examined; minutes
  std::size_t least_pairs = 4'000'000;
  std::size_t contacts = 4'000'000;  ///< kept, of all kinds; about 1 GB with what rules make of them
  std::size_t least_contacts = 64'000;
};

/// The contact of two triangles, ids and places of their corners given, where each is a face of its own.
geom::TriangleContact contact_of_lone_triangles(const std::array<PointId, 3>& a_ids,
                                                const std::array<geom::LatticePoint, 3>& a,
                                                const std::array<PointId, 3>& b_ids,
                                                const std::array<geom::LatticePoint, 3>& b, std::int64_t tolerance);

/// Searches all pairs of triangles of different faces whose boxes come within T. O(n log n + pairs), parallel; the
/// result depends neither on the number of threads nor on the order of faces (but for their ids).
Contacts find_contacts(const FaceTriangles& triangles, const geom::Tolerance& tolerance,
                       const SearchLimits& limits = {});

}  // namespace rad::validate
