// Defects of unit, axis and place.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

using scene::Scene;

Mutant whole(Scene scene) { return {std::move(scene), {{}, {}, {}, true}}; }

std::optional<Mutant> no_unit(const Survey& survey, Random& /*random*/) {
  if (!survey.scene().metres_per_unit) return std::nullopt;
  Scene scene = Draft(survey.scene()).scene();
  scene.metres_per_unit.reset();
  return whole(std::move(scene));
}

// The size of a hand.
std::optional<Mutant> wrong_unit(const Survey& survey, Random& random) {
  if (!survey.scene().metres_per_unit) return std::nullopt;
  Scene scene = Draft(survey.scene()).scene();
  const double diagonal = 1000 * survey.grain();
  scene.metres_per_unit = random.real(0.01, 0.3) / diagonal;
  return whole(std::move(scene));
}

std::optional<Mutant> no_axis(const Survey& survey, Random& /*random*/) {
  if (survey.scene().up == scene::UpAxis::Unknown) return std::nullopt;
  Scene scene = Draft(survey.scene()).scene();
  scene.up = scene::UpAxis::Unknown;
  return whole(std::move(scene));
}

// By a power of two: the model itself is not rounded by more than a millionth of T.
std::optional<Mutant> far_away(const Survey& survey, Random& random) {
  Scene scene = Draft(survey.scene()).scene();
  const double step = std::ldexp(1.0, std::ilogb(1000 * survey.grain()) + 12);
  const auto axis = static_cast<int>(random.index(3));
  geom::Box region;
  for (dvec3& p : scene.vertices) {
    p[axis] += step;
    region.add(p);
  }
  return Mutant{std::move(scene), {region, {}, {}, true}};
}

// A solid of 32 triangles around a point.
void add_gem(Draft& draft, const Spot& spot, const dvec3& at, double size, scene::MaterialId material,
             scene::ObjectId object) {
  constexpr std::size_t kSides = 16;
  std::vector<VertexId> ring;
  for (std::size_t i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kSides;
    ring.push_back(draft.add_vertex(at + size * (std::cos(angle) * spot.u + std::sin(angle) * spot.v)));
  }
  const VertexId top = draft.add_vertex(at + size * spot.normal), bottom = draft.add_vertex(at - size * spot.normal);
  for (std::size_t i = 0; i < kSides; ++i) {
    const VertexId a = ring[i], b = ring[(i + 1) % kSides];
    draft.add_face_of({a, b, top}, material, object);
    draft.add_face_of({b, a, bottom}, material, object);
  }
}

std::optional<Mutant> inches_among_centimetres(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  constexpr double kInch = 2.54;
  const double size = 0.4 * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  add_gem(draft, *spot, spot->point - 0.4 * spot->clearance * spot->u, size, material, draft.add_object("planted"));
  add_gem(draft, *spot, spot->point + 0.4 * spot->clearance * spot->u, size / kInch, material,
          draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

}  // namespace

std::span<const Mutator> unit_mutators() {
  static constexpr std::array<Mutator, 5> kMutators{{
      {"unit not declared", "RL501", {}, no_unit},
      {"model of the size of a hand", "RL502", {}, wrong_unit},
      {"model far from the origin", "RL503", {}, far_away},
      {"copy drawn in inches", "RL504", {}, inches_among_centimetres},
      {"up axis not declared", "RL505", {}, no_axis},
  }};
  return kMutators;
}

}  // namespace rad::corpus
