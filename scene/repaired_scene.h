// The conforming model as a scene, for writers and for another look by the rules.
#pragma once

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::scene {

enum class Pieces : std::uint8_t {
  Triangles,  ///< each face as the triangles of its triangulation; all of them in the order of space
  Faces,      ///< each face as one polygon with its holes
};

/// The model with the points that its pieces use, in the order of the model, as vertices in file units. Materials,
/// objects, groups, sections, unit and up axis are those of `origin`, the scene that the model was made from; each
/// piece refers to the place in the source of the face that most of it came from. The lattice and T are recorded.
Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces);

/// The same with the faces of which `whole` says so as polygons and the others as triangles, in the order of the model.
/// One entry for each face of the model.
Scene repaired_scene(const ConformingModel& model, const Scene& origin, const std::vector<bool>& whole);

}  // namespace rad::scene
