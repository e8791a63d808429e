// Every sound face as triangles on the lattice, and why the others have none.
#pragma once

#include <array>
#include <vector>

#include "geom/tolerance.h"
#include "geom/triangle_contact.h"
#include "scene/lattice_model.h"

namespace rad::validate {

using scene::FaceId;
using scene::PointId;

enum class FaceCondition : std::uint8_t {
  Sound,
  LeftOut,      ///< a corner is not finite: RL003
  Degenerate,   ///< nowhere thicker than T: RL007
  RingCrosses,  ///< RL009: edges of its rings cross; it has no inside to triangulate
};

/// What is wrong with a ring though the face can be triangulated (RL009, lesser kinds).
enum class RingFlaw : std::uint8_t { None, RepeatedPoint, Spike, HoleOutside };

struct FaceTriangle {
  std::array<PointId, 3> points;  ///< rotated so that the smallest id comes first
  FaceId face = 0;
};

struct FaceTriangles {
  std::vector<FaceTriangle> triangles;          ///< by face
  std::vector<geom::LatticeTriangle> geometry;  ///< the same triangles
  std::vector<FaceCondition> condition;         ///< per face
  std::vector<RingFlaw> flaw;                   ///< per face
  std::vector<geom::dvec3> normal;              ///< per face: Newell normal, length twice the area in pitches²
};

FaceTriangles triangulate_faces(const scene::Scene& scene, const scene::LatticeModel& model,
                                const geom::Tolerance& tolerance);

/// Newell normal of a face on the lattice: half its length is the area. Exact in 128 bits, then rounded.
geom::dvec3 newell_normal(const scene::Scene& scene, const scene::LatticeModel& model, const scene::Face& face);

}  // namespace rad::validate
