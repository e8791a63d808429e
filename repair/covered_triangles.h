// The triangles of a complex as the faces of a model: each with the piece that wins there, or with all that lie there.
#pragma once

#include "repair/conform.h"
#include "repair/maximal_faces.h"
#include "validate/context.h"

namespace rad::repair {

enum class Overlaps : std::uint8_t {
  Kept,      ///< a triangle for every piece that covers it: the model before Coplanar
  Resolved,  ///< one for each facing: the piece of the surface that wins
};

/// `scene` has the faces that the pieces name as their source.
PlanarTriangles planar_triangles(const Conformed& conformed, const scene::Scene& scene, Overlaps overlaps);

/// How many pieces lie under others of the same facing, triangle by triangle, and their area in pitches².
struct Covered {
  std::size_t cells = 0;
  double area = 0;
};
Covered covered_cells(const Conformed& conformed);

/// Of all triangles, pitches².
double area_of(const PlanarTriangles& set);

/// One face for each triangle, in order, with what its source face has of names and materials.
scene::Scene scene_of(const PlanarTriangles& set, const scene::Scene& origin, const geom::Lattice& lattice,
                      double tolerance);

/// Turns triangles over.
void turn(PlanarTriangles& set, const std::vector<scene::FaceId>& triangles);

}  // namespace rad::repair
