// How two lattice triangles meet, judged at the tolerance T: the question that Isect and Coplanar answer by cutting.
#pragma once

#include <array>
#include <span>

#include "geom/planar_clip.h"
#include "geom/predicates.h"

namespace rad::geom {

/// A triangle of a face's triangulation. `boundary[i]` tells whether the edge from point i to point i+1 is an edge of
/// the face and not a diagonal inside it.
struct LatticeTriangle {
  std::array<LatticePoint, 3> points;
  std::array<bool, 3> boundary{true, true, true};
  TrianglePlane plane;

  LatticeTriangle() = default;
  LatticeTriangle(const std::array<LatticePoint, 3>& corners, const std::array<bool, 3>& edges)
      : points(corners), boundary(edges), plane(corners[0], corners[1], corners[2]) {}
};

enum class ContactKind : std::uint8_t {
  None,        ///< apart by more than T, or meeting in a vertex or edge that both have within T
  Crossing,    ///< the interiors meet along a segment longer than T that runs along an edge of neither
  EdgeInFace,  ///< an edge or vertex of one meets the interior of the other, or two edges cross, without a vertex there
  Overlap,     ///< near-parallel, closer than T, and overlapping in a region thicker than T
};

struct TriangleContact {
  ContactKind kind = ContactKind::None;
  std::array<dvec3, 2> segment{};  ///< lattice coordinates; both ends equal for a point; for an Overlap the centroid
  double size = 0;                 ///< pitches; for an Overlap the area in pitches squared
  bool same_facing = true;         ///< of an Overlap: the normals point the same way
};

/// Near-parallel: normals within acos(0.999) = 2.6°, either way.
inline constexpr double kParallelCosine = 0.999;

bool near_parallel(const LatticeTriangle& a, const LatticeTriangle& b);

/// How two near-parallel triangles lie over each other, both projected along the normal of the larger.
struct ParallelOverlap {
  PlanarRegion region;  ///< in the plane of the larger; without area where they are beside each other
  double height = 0;    ///< pitches, of the smaller over the middle of the region; above 0 before the larger's front
  bool same_facing = true;
};

/// The overlap of two triangles that are near_parallel. Symmetric but for rounding, as contact_of.
ParallelOverlap parallel_overlap(const LatticeTriangle& a, const LatticeTriangle& b);

/// Sides of the corners of one triangle as seen from the plane of the other, at T.
using Sides = std::array<Sign, 3>;
Sides sides_of(const LatticeTriangle& triangle, const TrianglePlane& plane, std::int64_t tolerance);
bool all_on_one_side(const Sides& sides);

/// The kind of contact of two faces, each given by all its triangles, that have `segment` in common within T: judged by
/// the outlines of the faces. Never Overlap. Linear in the number of triangles.
ContactKind kind_along(const std::array<dvec3, 2>& segment, std::span<const LatticeTriangle> a,
                       std::span<const LatticeTriangle> b, std::int64_t tolerance);

/// The contact of a and b, both with area. `a_sides` are the sides of a's corners against b's plane and the other
/// way round; neither may be all on one side. Symmetric but for rounding: callers that need the same answer for (b,a)
/// pass the pair in a canonical order.
TriangleContact contact_of(const LatticeTriangle& a, const Sides& a_sides, const LatticeTriangle& b,
                           const Sides& b_sides, std::int64_t tolerance);

}  // namespace rad::geom
