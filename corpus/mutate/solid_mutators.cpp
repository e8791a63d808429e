// Defects of vertices and of solids with each other.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

// A closed tetrahedron: `tip`, and a base around `middle` that spans the three arms.
void add_tetrahedron(Draft& draft, VertexId tip, const dvec3& middle, const dvec3& arm, const dvec3& side,
                     scene::MaterialId material, scene::ObjectId object) {
  const VertexId a = draft.add_vertex(middle + arm), b = draft.add_vertex(middle - arm + side),
                 c = draft.add_vertex(middle - arm - side);
  draft.add_face_of({a, b, c}, material, object);
  draft.add_face_of({tip, b, a}, material, object);
  draft.add_face_of({tip, c, b}, material, object);
  draft.add_face_of({tip, a, c}, material, object);
}

// From a tip that is given along n to the base.
void add_pyramid(Draft& draft, VertexId tip, const dvec3& at, const dvec3& n, const Spot& spot, double size,
                 scene::MaterialId material, scene::ObjectId object) {
  const dvec3 arm = std::abs(glm::dot(spot.u, n)) < 0.5 ? spot.u : spot.v;
  add_tetrahedron(draft, tip, at + size * n, 0.5 * size * arm, 0.5 * size * glm::cross(n, arm), material, object);
}

std::optional<Mutant> loose_vertex(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 4 * survey.grain());
  if (!spot) return std::nullopt;
  Draft draft(survey.scene());
  draft.add_vertex(spot->point);
  return Mutant{draft.scene(), {ball_box(spot->point, survey.grain()), {}, {}}};
}

// Two pyramids of one object, tip to tip.
std::optional<Mutant> touching_tips(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const scene::ObjectId object = draft.add_object("planted");
  const VertexId tip = draft.add_vertex(spot->point);
  const double size = 0.5 * spot->clearance;
  add_pyramid(draft, tip, spot->point, spot->u, *spot, size, material, object);
  add_pyramid(draft, tip, spot->point, -spot->u, *spot, size, material, object);
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

// Five pyramids whose tips stand in a row, each less than T from the next. Their bases point five ways.
std::optional<Mutant> row_of_tips(const Survey& survey, Random& random) {
  const auto spot = spot_in_air(survey, random, 12 * survey.grain());
  if (!spot) return std::nullopt;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const double size = 0.5 * spot->clearance, step = 0.8 * tolerance_of(survey.scene());
  const std::array<dvec3, 5> ways{-spot->u, spot->v, -spot->v, spot->normal, spot->u};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const dvec3 at = spot->point + (static_cast<double>(i) * step) * spot->u;
    add_pyramid(draft, draft.add_vertex(at), at, ways[i], *spot, size, material, draft.add_object("planted"));
  }
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

std::optional<Mutant> box_in_box(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.5 * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = draft.add_material("planted");  // a lamp in a box is another defect
  for (const double size : {half, 0.4 * half}) {
    draft.add_box(spot->point, size * spot->u, size * spot->v, size * spot->normal, material,
                  draft.add_object("planted"));
  }
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

dvec3 front_of(const scene::Scene& scene, const scene::Face& face) {
  const auto corners = scene.corners_of(scene.loops_of(face)[0]);
  dvec3 sum(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 base = scene.vertices[corners[0]];
    sum += glm::cross(scene.vertices[corners[i]] - base, scene.vertices[corners[(i + 1) % corners.size()]] - base);
  }
  return glm::normalize(sum);
}

// All faces get the normals of their winding, one the opposite.
std::optional<Mutant> turned_normals(const Survey& survey, Random& random) {
  const FaceId wrong = all_faces(survey)[random.index(survey.scene().faces.size())];
  scene::Scene scene = Draft(survey.scene()).scene();
  auto& normals = scene.attributes.normals;
  normals.table.clear();
  normals.row_of_corner.assign(scene.corners.size(), scene::kNoRow);
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    normals.table.push_back(front_of(scene, scene.faces[id]) * (id == wrong ? -1.0 : 1.0));
    for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
      for (std::uint32_t i = 0; i < loop.count; ++i) normals.row_of_corner[loop.first + i] = id;
    }
  }
  return Mutant{std::move(scene), {survey.box(wrong), {wrong}, {}}};
}

// Without two sides that meet.
std::optional<Mutant> half_open_box(const Survey& survey, Random& random) {
  const auto spot = spot_in_air(survey, random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.5 * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  draft.add_box(spot->point, half * spot->u, half * spot->v, half * spot->normal, material,
                draft.add_object("planted"));
  draft.faces.pop_back();
  draft.faces.pop_back();
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

// A box that hangs over a face by some T.
std::optional<Mutant> hovering_box(const Survey& survey, Random& random) {
  const auto spot = survey.spot(random, 6 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.35 * spot->clearance, gap = random.real(2, 15) * tolerance_of(survey.scene());
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  draft.add_box(spot->point + (half + gap) * spot->normal, half * spot->u, half * spot->v, half * spot->normal,
                material, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

std::optional<Mutant> floating_sheet(const Survey& survey, Random& random) {
  const auto spot = survey.spot(random, 6 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.4 * spot->clearance, gap = random.real(2, 15) * tolerance_of(survey.scene());
  const dvec3 at = spot->point + gap * spot->normal, u = half * spot->u, v = half * spot->v;
  Draft draft(survey.scene());
  draft.add_face({at - u - v, at + u - v, at + u + v, at - u + v}, survey.scene().faces[spot->face].material,
                 draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

constexpr std::array<std::string_view, 1> kCrack{"RL302"};

}  // namespace

std::span<const Mutator> solid_mutators() {
  static constexpr std::array<Mutator, 8> kMutators{{
      {"vertex without a face", "RL004", {}, loose_vertex},
      {"two pyramids tip to tip", "RL103", {}, touching_tips},
      {"box without two sides", "RL105", {}, half_open_box},
      {"solid inside a solid", "RL106", {}, box_in_box},
      {"normals of a face turned over", "RL111", {}, turned_normals},
      {"tips in a row, 0.8 T apart", "RL122", kCrack, row_of_tips},
      {"box that hovers", "RL212", {}, hovering_box},
      {"sheet that floats", "RL223", {}, floating_sheet},
  }};
  return kMutators;
}

}  // namespace rad::corpus
