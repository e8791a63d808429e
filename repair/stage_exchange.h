// A complex as what a stage file holds, and back: so that filters run one by one do what they do in one run.
#pragma once

#include <memory>

#include "repair/complex.h"
#include "repair/maximal_faces.h"
#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::repair {

/// The complex as a scene with a record: a face for every piece that is left, in order, its chain of edges as loops.
/// Points keep their order; those that nothing uses are left out. `origin` has the faces that the pieces name.
scene::Scene stage_scene(const Complex& complex, const scene::Scene& origin, const geom::Lattice& lattice,
                         double tolerance);

/// The faces of `model` as a scene with a record, with their triangles: what comes after Coplanar. `set` is what the
/// model was made of.
scene::Scene stage_scene(const scene::ConformingModel& model, const PlanarTriangles& set, const scene::Scene& origin);

/// The faces of a scene as they are: a record without planes.
scene::Scene stage_scene(const scene::Scene& scene, const geom::Lattice& lattice, double tolerance);

/// What was made into a record by the first of these; needs planes and no triangles. Pieces name the faces of `scene`.
std::unique_ptr<Complex> complex_of(const scene::Scene& scene);

/// What was made into a record by the second; needs triangles. Members name the faces of `scene`.
PlanarTriangles triangles_of(const scene::Scene& scene);

}  // namespace rad::repair
