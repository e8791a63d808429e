// Defects of materials and lights.
#include <algorithm>
#include <array>
#include <memory>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

using scene::Material;
using scene::Scene;

// A material that some face has; emitting or not.
std::optional<scene::MaterialId> some_material(const Scene& scene, Random& random, bool emitting) {
  std::vector<scene::MaterialId> used;
  for (const scene::Face& face : scene.faces) {
    if (scene.materials[face.material].emits() == emitting) used.push_back(face.material);
  }
  if (used.empty()) return std::nullopt;
  return used[random.index(used.size())];
}

geom::Box box_of_material(const Survey& survey, scene::MaterialId material) {
  geom::Box box;
  for (const FaceId face : all_faces(survey)) {
    if (survey.scene().faces[face].material != material) continue;
    box.add(survey.box(face).low);
    box.add(survey.box(face).high);
  }
  return box;
}

// Changes a material that does not emit.
template <typename Change>
std::optional<Mutant> changed_material(const Survey& survey, Random& random, Change change) {
  const auto material = some_material(survey.scene(), random, false);
  if (!material) return std::nullopt;
  Scene scene = Draft(survey.scene()).scene();
  change(scene.materials[*material]);
  return Mutant{std::move(scene), {box_of_material(survey, *material), {}, {}}};
}

std::optional<Mutant> too_white(const Survey& survey, Random& random) {
  const double white = random.real(0.96, 1.5);
  return changed_material(survey, random, [&](Material& material) { material.reflectance = dvec3(white); });
}

std::optional<Mutant> cancelled_light(const Survey& survey, Random& random) {
  return changed_material(survey, random, [](Material& material) { material.emission_cancelled = true; });
}

std::optional<Mutant> mirror(const Survey& survey, Random& random) {
  return changed_material(survey, random, [](Material& material) { material.specular = dvec3(0.6); });
}

std::optional<Mutant> glass(const Survey& survey, Random& random) {
  const double opacity = random.real(0, 0.9);
  return changed_material(survey, random, [&](Material& material) { material.opacity = opacity; });
}

std::optional<Mutant> picture(const Survey& survey, Random& random) {
  const auto image = std::make_shared<const scene::Image>(scene::Image{.path = "planted.png"});
  return changed_material(survey, random, [&](Material& material) {
    material.texture = {.image = image,
                        .factor = {material.reflectance.x, material.reflectance.y, material.reflectance.z}};
  });
}

bool any_emits(const Survey& survey) {
  const Scene& scene = survey.scene();
  return std::ranges::any_of(scene.faces,
                             [&](const scene::Face& face) { return scene.materials[face.material].emits(); });
}

std::optional<Mutant> all_dark(const Survey& survey, Random& /*random*/) {
  if (!any_emits(survey)) return std::nullopt;
  Scene scene = Draft(survey.scene()).scene();
  for (Material& material : scene.materials) material.emission = dvec3(0);
  return Mutant{std::move(scene), {{}, {}, {}, true}};
}

scene::MaterialId add_lamp(Draft& draft) {
  const scene::MaterialId lamp = draft.add_material("planted");
  draft.material(lamp).emission = dvec3(100);
  return lamp;
}

// Only where no other lamp has a unit that is not known.
std::optional<Mutant> lamp_without_unit(const Survey& survey, Random& random) {
  const auto spot = survey.free_spot(random, 4 * survey.grain());
  if (!spot || any_emits(survey)) return std::nullopt;
  const double half = 0.4 * spot->clearance;
  Draft draft(survey.scene());
  draft.add_box(spot->point, half * spot->u, half * spot->v, half * spot->normal, add_lamp(draft),
                draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

std::optional<Mutant> shut_lamp(const Survey& survey, Random& random) {
  // Where it is the only lamp, the box is taken for a room that is turned over.
  const auto spot = spot_in_air(survey, random, 8 * survey.grain());
  if (!spot || !any_emits(survey)) return std::nullopt;
  const double half = 0.5 * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  draft.add_box(spot->point, half * spot->u, half * spot->v, half * spot->normal, material,
                draft.add_object("planted"));
  draft.add_box(spot->point, 0.4 * half * spot->u, 0.4 * half * spot->v, 0.4 * half * spot->normal, add_lamp(draft),
                draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

std::optional<Mutant> lost_lamp(const Survey& survey, Random& random) {
  geom::Box box;
  for (const FaceId face : all_faces(survey)) {
    box.add(survey.box(face).low);
    box.add(survey.box(face).high);
  }
  const double diagonal = box.diagonal();
  dvec3 at = (box.low + box.high) * 0.5;
  at[static_cast<int>(random.index(3))] += 2.5 * diagonal;
  const double half = 0.1 * diagonal;
  Draft draft(survey.scene());
  draft.add_box(at, {half, 0, 0}, {0, half, 0}, {0, 0, half}, add_lamp(draft), draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(at, 2 * half), {}, {}}};
}

// A sheet just in front of a face, looking at it.
std::optional<Mutant> turned_lamp(const Survey& survey, Random& random) {
  const auto spot = survey.spot(random, 8 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = 0.5 * spot->clearance;
  const dvec3 at = spot->point + 0.05 * spot->clearance * spot->normal;
  const dvec3 u = half * spot->u, v = half * spot->v;
  Draft draft(survey.scene());
  draft.add_face({at - u - v, at - u + v, at + u + v, at + u - v}, add_lamp(draft), draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {}, {}}};
}

}  // namespace

std::span<const Mutator> material_mutators() {
  static constexpr std::array<Mutator, 10> kMutators{{
      {"reflectance above 0.95", "RL401", {}, too_white},
      {"all lights put out", "RL402", {}, all_dark},
      {"lamp turned to its wall", "RL403", {}, turned_lamp},
      {"lamp without a unit", "RL404", {}, lamp_without_unit},
      {"light multiplied by 0", "RL405", {}, cancelled_light},
      {"polished material", "RL406", {}, mirror},
      {"glass", "RL407", {}, glass},
      {"texture", "RL408", {}, picture},
      {"lamp in a closed box", "RL420", {}, shut_lamp},
      {"lamp far away", "RL421", {}, lost_lamp},
  }};
  return kMutators;
}

}  // namespace rad::corpus
