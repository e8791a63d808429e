// Defects of single faces.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

// A face by itself in free space, of points in units of the room there is, in the plane of u and the normal.
std::optional<Mutant> lone_face(const Survey& survey, Random& random, const std::vector<std::array<double, 2>>& ring) {
  const auto spot = survey.free_spot(random, 4 * survey.grain());
  if (!spot) return std::nullopt;
  const double unit = spot->clearance * 0.6;
  std::vector<dvec3> points;
  for (const auto& [a, b] : ring) points.push_back(spot->point + unit * (a * spot->u + b * spot->normal));
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const FaceId face = draft.add_face(points, material, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {face}, {}}};
}

std::optional<Mutant> collapsed_face(const Survey& survey, Random& random) {
  return lone_face(survey, random, {{-1, 0}, {1, 0}, {0.3, 0}});
}

std::optional<Mutant> crossing_ring(const Survey& survey, Random& random) {
  return lone_face(survey, random, {{-0.7, -0.7}, {0.7, -0.7}, {-0.35, 0.7}, {0.45, 0.35}});
}

std::optional<Mutant> concave_face(const Survey& survey, Random& random) {
  return lone_face(survey, random, {{-0.8, -0.5}, {0, -0.1}, {0.8, -0.5}, {0, 0.8}});
}

std::optional<Mutant> needle(const Survey& survey, Random& random) {
  return lone_face(survey, random, {{-0.95, -0.03}, {0.95, 0}, {-0.95, 0.03}});
}

std::optional<Mutant> repeated_corner(const Survey& survey, Random& random) {
  const FaceId face = all_faces(survey)[random.index(survey.scene().faces.size())];
  Draft draft(survey.scene());
  auto& loop = draft.faces[face].loops[0];
  const std::size_t corner = random.index(loop.size());
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner), loop[corner]);
  return Mutant{draft.scene(), {survey.box(face), {face}, {}}};
}

std::optional<Mutant> doubled_vertex(const Survey& survey, Random& random) {
  const FaceId face = all_faces(survey)[random.index(survey.scene().faces.size())];
  Draft draft(survey.scene());
  auto& loop = draft.faces[face].loops[0];
  VertexId& corner = loop[random.index(loop.size())];
  const dvec3 place = survey.position(corner);
  corner = draft.add_vertex(place);
  return Mutant{draft.scene(), {ball_box(place, survey.grain()), {face}, {}}};
}

bool strictly_convex(const Survey& survey, FaceId face) {
  const auto ring = survey.outer(face);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 &a = survey.position(ring[i]), &b = survey.position(ring[(i + 1) % ring.size()]),
                &c = survey.position(ring[(i + 2) % ring.size()]);
    const double turn = glm::dot(glm::cross(b - a, c - b), survey.normal(face));
    constexpr double kClearTurn = 0.05;
    if (turn < kClearTurn * glm::length(b - a) * glm::length(c - b)) return false;
  }
  return true;
}

std::optional<Mutant> split_face(const Survey& survey, Random& random) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    const std::size_t corners = survey.outer(face).size();
    if (survey.scene().faces[face].loop_count > 1 || corners < 4 || !strictly_convex(survey, face)) return std::nullopt;
    Draft draft(survey.scene());
    const std::vector<VertexId> ring = draft.faces[face].loops[0];
    const std::size_t first = random.index(corners - 2), second = first + 2;
    const dvec3 chord = (survey.position(ring[first]) + survey.position(ring[second])) * 0.5;
    if (survey.distance(chord, std::span(&face, 1)) < survey.grain()) return std::nullopt;
    DraftFace half = draft.faces[face];
    const auto at = [&ring](std::size_t i) { return ring.begin() + static_cast<std::ptrdiff_t>(i); };
    half.loops[0].assign(at(first), at(second + 1));
    draft.faces[face].loops[0].erase(draft.faces[face].loops[0].begin() + static_cast<std::ptrdiff_t>(first) + 1);
    draft.faces.push_back(half);
    return Mutant{draft.scene(), {survey.box(face), {face, static_cast<FaceId>(draft.faces.size() - 1)}, {}}};
  });
}

// Moves the vertex along the normal of a face with more than three corners.
std::optional<Mutant> lift(const Survey& survey, FaceId face, VertexId vertex) {
  const std::vector<FaceId> around = survey.faces_at(vertex);
  if (survey.distance(survey.position(vertex), around) < 6 * survey.grain()) return std::nullopt;
  Planted planted{ball_box(survey.position(vertex), 2 * survey.grain()), around, {}};
  for (const FaceId id : around) {
    const auto ring = survey.outer(id);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double side = glm::distance(survey.position(ring[i]), survey.position(ring[(i + 1) % ring.size()]));
      if (side < 6 * survey.grain()) return std::nullopt;
      planted.region.add(survey.position(ring[i]));
    }
  }
  Draft draft(survey.scene());
  draft.vertex(vertex) += survey.normal(face) * survey.grain();
  return Mutant{draft.scene(), std::move(planted)};
}

std::optional<Mutant> lifted_corner(const Survey& survey, Random& random) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    if (!survey.is_private(face) || survey.outer(face).size() < 4) return std::nullopt;
    const VertexId vertex = survey.outer(face)[random.index(survey.outer(face).size())];
    return survey.is_private_vertex(vertex) ? lift(survey, face, vertex) : std::nullopt;
  });
}

// A corner of one face moved along its edge by half the tolerance, with a vertex of its own.
std::optional<Mutant> nudged_corner(const Survey& survey, Random& random) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    if (!survey.is_private(face)) return std::nullopt;
    const auto ring = survey.outer(face);
    const std::size_t at = random.index(ring.size());
    const dvec3 corner = survey.position(ring[at]);
    const dvec3 along = survey.position(ring[(at + 1) % ring.size()]) - corner;
    if (glm::length(along) < 6 * survey.grain() || !survey.is_private_vertex(ring[at])) return std::nullopt;
    Draft draft(survey.scene());
    const double step = 0.5 * tolerance_of(survey.scene());
    draft.faces[face].loops[0][at] = draft.add_vertex(corner + step * glm::normalize(along));
    return Mutant{draft.scene(), {ball_box(corner, survey.grain()), {face}, {}}};
  });
}

}  // namespace

std::span<const Mutator> face_mutators() {
  static constexpr std::array<Mutator, 9> kMutators{{
      {"face collapsed to a line", "RL007", {}, collapsed_face},
      {"ring that crosses itself", "RL009", {}, crossing_ring},
      {"corner repeated", "RL009", {}, repeated_corner},
      {"vertex doubled", "RL005", {}, doubled_vertex},
      {"corner lifted off its plane", "RL008", {}, lifted_corner},
      {"planar face split in two", "RL120", {}, split_face},
      {"concave face", "RL230", {}, concave_face},
      {"needle", "RL240", {}, needle},
      {"corner nudged by T/2", "RL302", {}, nudged_corner},
  }};
  return kMutators;
}

}  // namespace rad::corpus
