// Defects about as small as the tolerance.
#include <array>
#include <glm/geometric.hpp>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

// Above T, so that nothing of it is degenerate, and below the weld distance of 1.16 T.
constexpr double kBarely = 1.08;

std::optional<Mutant> thin_plate(const Survey& survey, Random& random) {
  const auto spot = spot_in_air(survey, random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.5 * spot->clearance, thickness = kBarely * tolerance_of(survey.scene());
  Draft draft(survey.scene());
  draft.add_box(spot->point, half * spot->u, half * spot->v, 0.5 * thickness * spot->normal,
                survey.scene().faces[spot->face].material, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

// Both faces at an edge get a vertex near one of its ends.
std::optional<Mutant> vertex_near_a_corner(const Survey& survey, Random& random) {
  return first_that_plants(survey.edges(), random, [&](const Edge& edge) -> std::optional<Mutant> {
    const dvec3 end = survey.position(edge.a), along = survey.position(edge.b) - end;
    if (edge.uses.size() != 2 || edge.uses[0].face == edge.uses[1].face) return std::nullopt;
    if (glm::length(along) < 4 * survey.grain()) return std::nullopt;
    const dvec3 at = end + kBarely * tolerance_of(survey.scene()) * glm::normalize(along);
    Draft draft(survey.scene());
    const VertexId vertex = draft.add_vertex(at);
    for (const EdgeUse& use : edge.uses) {
      auto& loop = draft.faces[use.face].loops[use.loop];
      loop.insert(loop.begin() + use.corner + 1, vertex);
    }
    return Mutant{draft.scene(), {ball_box(at, survey.grain()), {edge.uses[0].face, edge.uses[1].face}, {}}};
  });
}

// A quadrilateral in free space, bent so that its diagonals pass each other at 1.5 T: flat enough for RL008.
std::optional<Mutant> bent_quad(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 4 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.5 * spot->clearance;
  const dvec3 u = half * spot->u, v = half * spot->v, up = 0.75 * tolerance_of(survey.scene()) * spot->normal;
  const dvec3& at = spot->point;
  Draft draft(survey.scene());
  const FaceId face = draft.add_face({at - u - v + up, at + u - v - up, at + u + v + up, at - u + v - up},
                                     survey.scene().faces[spot->face].material, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(at, spot->clearance), {face}, {}}};
}

}  // namespace

std::span<const Mutator> fine_mutators() {
  static constexpr std::array<Mutator, 3> kMutators{{
      {"plate of 1.08 T", "RL107", {}, thin_plate},
      {"vertex 1.08 T from a corner", "RL108", {}, vertex_near_a_corner},
      {"quadrilateral bent by 1.5 T", "RL303", {}, bent_quad},
  }};
  return kMutators;
}

}  // namespace rad::corpus
