// The repaired model: planar faces on the lattice that meet each other in shared vertices and edges only.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geom/lattice.h"
#include "geom/tolerance.h"
#include "scene/lattice_model.h"
#include "scene/scene.h"

namespace rad::scene {

/// In triangle_sources: a triangle that came from no face of the input, such as one that closes a hole.
inline constexpr FaceId kNoSource = 0xffffffffu;

/// A face of the repaired model. `loops[first_loop]` is the outer loop, counter-clockwise seen from the front; the
/// others are holes, clockwise. A loop visits each of its points once; loops of one face may touch in points.
struct ConformingFace {
  std::uint32_t first_loop = 0;
  std::uint32_t loop_count = 0;
  std::uint32_t first_inner_edge =
      0;  ///< edges inside the face where another face touches it: both sides are this face
  std::uint32_t inner_edge_count = 0;
  std::uint32_t first_triangle = 0;  ///< of its triangulation, which uses all its points and points inside it
  std::uint32_t triangle_count = 0;
  MaterialId material = 0;
  ObjectId object = 0;
  GroupId group = 0;
  FaceId source = 0;  ///< the face of the input scene that most of it came from
};

/// Every edge of a loop and every inner edge is used whole by all faces that touch it; no point lies within T of an
/// edge or a triangle that does not use it.
struct ConformingModel {
  geom::Lattice lattice;
  geom::Tolerance tolerance;
  std::vector<geom::LatticePoint> points;

  std::vector<PointId> corners;
  std::vector<Loop> loops;
  std::vector<std::array<PointId, 2>> inner_edges;
  std::vector<std::array<PointId, 3>> triangles;  ///< counter-clockwise seen from the front of their face
  std::vector<FaceId> triangle_sources;           ///< per triangle: the face of the input scene, or kNoSource
  std::vector<ConformingFace> faces;

  [[nodiscard]] std::span<const PointId> corners_of(const Loop& loop) const {
    return std::span(corners).subspan(loop.first, loop.count);
  }
  [[nodiscard]] std::span<const Loop> loops_of(const ConformingFace& face) const {
    return std::span(loops).subspan(face.first_loop, face.loop_count);
  }
  [[nodiscard]] std::span<const std::array<PointId, 2>> inner_edges_of(const ConformingFace& face) const {
    return std::span(inner_edges).subspan(face.first_inner_edge, face.inner_edge_count);
  }
  [[nodiscard]] std::span<const std::array<PointId, 3>> triangles_of(const ConformingFace& face) const {
    return std::span(triangles).subspan(face.first_triangle, face.triangle_count);
  }
};

}  // namespace rad::scene
