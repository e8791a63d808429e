// Defects of connected surfaces: which side they look to, and where their texture goes on.
#include <algorithm>
#include <array>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

// Of five triangles, within the unit ball.
std::optional<Mutant> moebius_strip(const Survey& survey, Random& random) {
  const auto spot = spot_in_air(survey, random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  constexpr std::array<dvec3, 5> kCorners{
      {{-0.3, -0.5, -0.1}, {0.5, -0.5, 0.0}, {0.7, 0.2, 0.2}, {0.0, 0.6, 0.0}, {-0.7, 0.1, 0.3}}};
  Draft draft(survey.scene());
  std::array<VertexId, 5> vertices{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const dvec3 at = 0.7 * spot->clearance * kCorners[i];
    vertices[i] = draft.add_vertex(spot->point + at.x * spot->u + at.y * spot->v + at.z * spot->normal);
  }
  const scene::ObjectId object = draft.add_object("planted");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    draft.add_face_of({vertices[i], vertices[(i + 1) % 5], vertices[(i + 2) % 5]},
                      survey.scene().faces[spot->face].material, object);
  }
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

// The only lamp of the model stands in a box that looks outward: a room drawn the wrong way round.
std::optional<Mutant> room_inside_out(const Survey& survey, Random& random) {
  const auto spot = spot_in_air(survey, random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  Draft draft(survey.scene());
  for (scene::MaterialId id = 0; id < survey.scene().materials.size(); ++id) draft.material(id).emission = dvec3(0);
  const dvec3 u = 0.5 * spot->clearance * spot->u, v = 0.5 * spot->clearance * spot->v,
              n = 0.5 * spot->clearance * spot->normal;
  const scene::MaterialId wall = draft.add_material("wall"), lamp = draft.add_material("lamp");
  draft.material(lamp).emission = dvec3(100);
  draft.add_box(spot->point, u, v, n, wall, draft.add_object("planted"));
  draft.add_box(spot->point, 0.4 * u, 0.4 * v, 0.4 * n, lamp, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

// A square in two halves that show different places of an image.
std::optional<Mutant> texture_seam(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 4 * survey.grain());
  if (!spot) return std::nullopt;
  const dvec3 u = 0.5 * spot->clearance * spot->u, v = 0.5 * spot->clearance * spot->v;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const scene::ObjectId object = draft.add_object("planted");
  const VertexId a = draft.add_vertex(spot->point - u - v), b = draft.add_vertex(spot->point + u - v),
                 c = draft.add_vertex(spot->point + u + v), d = draft.add_vertex(spot->point - u + v);
  const std::array<FaceId, 2> halves{draft.add_face_of({a, b, c}, material, object),
                                     draft.add_face_of({a, c, d}, material, object)};
  scene::Scene scene = draft.scene();
  auto& coordinates = scene.attributes.texture_coordinates;
  coordinates.row_of_corner.resize(scene.corners.size(), scene::kNoRow);
  for (const FaceId half : halves) {
    const scene::Loop& loop = scene.loops_of(scene.faces[half])[0];
    constexpr std::array<scene::dvec2, 3> kSame{{{0, 0}, {1, 0}, {1, 1}}};
    for (std::uint32_t i = 0; i < loop.count; ++i) {
      coordinates.row_of_corner[loop.first + i] = static_cast<scene::RowId>(coordinates.table.size());
      coordinates.table.push_back(kSame[i]);
    }
  }
  return Mutant{std::move(scene), {ball_box(spot->point, spot->clearance), {halves[0], halves[1]}, {}}};
}

}  // namespace

std::span<const Mutator> surface_mutators() {
  static constexpr std::array<Mutator, 3> kMutators{{
      {"room drawn inside out", "RL112", {}, room_inside_out},
      {"Moebius strip", "RL115", {}, moebius_strip},
      {"seam of the texture", "RL121", {}, texture_seam},
  }};
  return kMutators;
}

}  // namespace rad::corpus
