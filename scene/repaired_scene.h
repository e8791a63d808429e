// The conforming model as a scene, for writers and for another look by the rules.
#pragma once

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::scene {

enum class Pieces : std::uint8_t {
  Triangles,  ///< the triangles of all faces, in the order of space
  Faces,      ///< each face as one polygon with its holes
};

/// The model with the points that its pieces use, in the order of the model, as vertices in file units. Materials,
/// objects, groups, sections, unit and up axis are those of `origin`, the scene that the model was made from; each
/// piece refers to the place in the source of the face that most of it came from, and has the smoothing group of that
/// face. Texture coordinates and normals are those of the faces that the triangles came from (AttributeTransfer). The
/// lattice and T are recorded.
Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces);

/// A scene and what each of its faces is of the model.
struct PiecesOfModel {
  static constexpr std::uint32_t kWhole = 0xffffffffu;

  Scene scene;
  std::vector<std::uint32_t> face;      ///< per face of the scene: the face of the model
  std::vector<std::uint32_t> triangle;  ///< likewise the triangle of the model; kWhole for a whole face
};

/// Each face as one polygon, but for those of `as_triangles` (one flag for each face of the model). Where all are, the
/// triangles stand in the order of space, else face by face.
PiecesOfModel pieces_of(const ConformingModel& model, const Scene& origin, const std::vector<bool>& as_triangles);

}  // namespace rad::scene
