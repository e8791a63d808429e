// Defects of edges and of orientation: what the Grouper needs to be right.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

// Faces that meet at less or more than the 30 degrees of one surface, by a margin.
constexpr double kClearlySmooth = 0.9, kClearlySharp = 0.8;

enum class Joint { WithinSurface, BetweenSurfaces, Unclear };

Joint joint_of(const Survey& survey, const Edge& edge) {
  const scene::Face& f = survey.scene().faces[edge.uses[0].face];
  const scene::Face& g = survey.scene().faces[edge.uses[1].face];
  const double cosine = glm::dot(survey.normal(edge.uses[0].face), survey.normal(edge.uses[1].face));
  if (f.material != g.material || cosine < kClearlySharp) return Joint::BetweenSurfaces;
  return cosine > kClearlySmooth ? Joint::WithinSurface : Joint::Unclear;
}

bool joins_two_faces(const Edge& edge) {
  return edge.uses.size() == 2 && edge.uses[0].face != edge.uses[1].face &&
         edge.uses[0].forward != edge.uses[1].forward;
}

dvec3 middle(const Survey& survey, const Edge& edge) {
  return (survey.position(edge.a) + survey.position(edge.b)) * 0.5;
}

double room_around(const Survey& survey, const Edge& edge) {
  const std::array<FaceId, 2> own{edge.uses[0].face, edge.uses[1].face};
  return survey.distance(middle(survey, edge), own);
}

// Only one of the two faces learns of the new vertex.
std::optional<Mutant> split_one_side(const Survey& survey, Random& random, Joint joint) {
  return first_that_plants(survey.edges(), random, [&](const Edge& edge) -> std::optional<Mutant> {
    const double length = glm::distance(survey.position(edge.a), survey.position(edge.b));
    if (!joins_two_faces(edge) || joint_of(survey, edge) != joint || length < 4 * survey.grain()) return std::nullopt;
    if (room_around(survey, edge) < survey.grain() / 2) return std::nullopt;
    Draft draft(survey.scene());
    const EdgeUse& use = edge.uses[random.index(2)];
    auto& loop = draft.faces[use.face].loops[use.loop];
    loop.insert(loop.begin() + use.corner + 1, draft.add_vertex(middle(survey, edge)));
    return Mutant{draft.scene(),
                  {ball_box(middle(survey, edge), survey.grain()), {edge.uses[0].face, edge.uses[1].face}, {}}};
  });
}

std::optional<Mutant> t_vertex(const Survey& survey, Random& random) {
  return split_one_side(survey, random, Joint::WithinSurface);
}

std::optional<Mutant> t_vertex_between_surfaces(const Survey& survey, Random& random) {
  return split_one_side(survey, random, Joint::BetweenSurfaces);
}

std::optional<Mutant> third_face(const Survey& survey, Random& random) {
  return first_that_plants(survey.edges(), random, [&](const Edge& edge) -> std::optional<Mutant> {
    if (!joins_two_faces(edge)) return std::nullopt;
    const scene::Face& owner = survey.scene().faces[edge.uses[0].face];
    if (survey.scene().faces[edge.uses[1].face].object != owner.object) return std::nullopt;
    const dvec3 sum = survey.normal(edge.uses[0].face) + survey.normal(edge.uses[1].face);
    const double room = room_around(survey, edge);
    constexpr double kOpenEnough = 0.5;
    if (glm::length(sum) < kOpenEnough || room < 8 * survey.grain()) return std::nullopt;
    Draft draft(survey.scene());
    const dvec3 apex = middle(survey, edge) + glm::normalize(sum) * (0.4 * room);
    const FaceId fin = draft.add_face_of({edge.a, edge.b, draft.add_vertex(apex)}, owner.material, owner.object);
    geom::Box region = ball_box(apex, survey.grain());
    region.add(survey.position(edge.a));
    region.add(survey.position(edge.b));
    return Mutant{draft.scene(), {region, {edge.uses[0].face, edge.uses[1].face, fin}, {}}};
  });
}

bool in_closed_object(const Survey& survey, FaceId face) {
  const ObjectFacts& object = survey.objects()[survey.scene().faces[face].object];
  return object.closed && object.volume > 0 && object.faces.size() > 4;
}

std::optional<Mutant> flipped_face(const Survey& survey, Random& random) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    if (!survey.is_private(face) || !in_closed_object(survey, face)) return std::nullopt;
    Draft draft(survey.scene());
    reverse(draft.faces[face]);
    return Mutant{draft.scene(), {survey.box(face), {face}, {}}};
  });
}

std::optional<Mutant> flipped_object(const Survey& survey, Random& random) {
  return first_that_plants(survey.objects(), random, [&](const ObjectFacts& object) -> std::optional<Mutant> {
    if (object.faces.empty() || !object.closed || !object.alone || object.holds_others || object.volume <= 0) {
      return std::nullopt;
    }
    // Turned inside out, a lamp is a room with a light in it, and the only object of a scene is a room as well.
    const auto& faces = survey.scene().faces;
    const auto emits = [&](FaceId face) { return survey.scene().materials[faces[face].material].emits(); };
    if (object.faces.size() == faces.size() || std::any_of(object.faces.begin(), object.faces.end(), emits)) {
      return std::nullopt;
    }
    Draft draft(survey.scene());
    for (const FaceId face : object.faces) reverse(draft.faces[face]);
    return Mutant{draft.scene(), {object.box, object.faces, {}}};
  });
}

// Whether a ray along the normal from the middle of the face meets the box of another object.
bool looks_at_an_object(const Survey& survey, FaceId face) {
  const dvec3 from = (survey.box(face).low + survey.box(face).high) * 0.5, along = survey.normal(face);
  const auto& objects = survey.objects();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (i == survey.scene().faces[face].object || objects[i].faces.empty()) continue;
    double enter = 0, leave = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (objects[i].box.low[axis] - from[axis]) / along[axis];
      const double b = (objects[i].box.high[axis] - from[axis]) / along[axis];
      enter = std::fmax(enter, std::fmin(a, b));
      leave = std::fmin(leave, std::fmax(a, b));
      const bool aside = from[axis] < objects[i].box.low[axis] || from[axis] > objects[i].box.high[axis];
      if (along[axis] == 0 && aside) leave = -1;
    }
    if (enter < leave) return true;
  }
  return false;
}

// A wide face of an object is taken away, so that others see it from within.
std::optional<Mutant> opened_object(const Survey& survey, Random& random) {
  constexpr double kWide = 0.7;
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    const ObjectFacts& object = survey.objects()[survey.scene().faces[face].object];
    if (!survey.is_private(face) || !in_closed_object(survey, face) || !object.alone) return std::nullopt;
    if (survey.box(face).diagonal() < kWide * object.box.diagonal()) return std::nullopt;
    if (!looks_at_an_object(survey, face)) return std::nullopt;
    Draft draft(survey.scene());
    draft.faces.erase(draft.faces.begin() + face);
    return Mutant{draft.scene(), {object.box, {}, {}}};
  });
}

std::optional<Mutant> removed_face(const Survey& survey, Random& random) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    if (!survey.is_private(face) || !in_closed_object(survey, face)) return std::nullopt;
    Draft draft(survey.scene());
    draft.faces.erase(draft.faces.begin() + face);
    return Mutant{draft.scene(), {survey.box(face), {}, {}}};
  });
}

}  // namespace

std::span<const Mutator> edge_mutators() {
  static constexpr std::array<Mutator, 7> kMutators{{
      {"t-vertex within a surface", "RL201", {}, t_vertex},
      {"t-vertex between surfaces", "RL301", {}, t_vertex_between_surfaces},
      {"third face on an edge", "RL102", {}, third_face},
      {"face turned over", "RL110", {}, flipped_face},
      {"object turned inside out", "RL104", {}, flipped_object},
      {"face taken away", "RL101", {}, removed_face},
      {"object opened", "RL113", {}, opened_object},
  }};
  return kMutators;
}

}  // namespace rad::corpus
