// The models of this project: small scenes made by hand, and large clean meshes of any size.
#pragma once

#include <span>
#include <string_view>

#include "scene/scene.h"

namespace rad::corpus {

/// The scene of the paper's Color Plate 1 as a modeller exports it: the concave ground with a hole cut into quads whose
/// corners do not meet, a box and a lamp post pushed through it, a lamp set on the post. Broken on purpose.
scene::Scene lamp_post();
/// The same scene as it should be: one maximal ground face, contours where box and post pass through it.
scene::Scene lamp_post_repaired();
/// A closed room of inward faces with furniture that stands in contours of the floor. Clean.
scene::Scene furnished_room();
/// Two rooms joined by a door opening, walls with thickness, one closed solid. Clean.
scene::Scene two_room_flat();

/// A closed sphere of 10 m radius made of 20 f² triangles, the nearest such number to `triangles`; f at least 1.
scene::Scene clean_sphere(std::size_t triangles);
/// Hills of n by n cells of 1 m, two triangles each. n at least 1.
scene::Scene clean_terrain(std::size_t n);
/// n by n closed blocks of different heights, streets between them, and a lamp above. n at least 1.
scene::Scene clean_city(std::size_t n);

/// A furnished house and a theatre in the manner of the paper's two models (Table 3), as CAD programs export them: with
/// T-vertices, faces through one another, sheets in the planes of others, facades. About 8 600 and 5 300 faces.
scene::Scene house();
scene::Scene theatre();

/// A model that is kept as a file under corpus/models.
struct Model {
  std::string_view name;  ///< without suffix
  scene::Scene (*make)();
  bool clean = true;  ///< meets the stage `model`
};
std::span<const Model> kept_models();
/// Models that are made when they are needed.
std::span<const Model> made_models();

}  // namespace rad::corpus
