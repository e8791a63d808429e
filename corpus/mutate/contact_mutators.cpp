// Defects of faces with each other: overlaps and intersections.
#include <array>

#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

enum class Copy { SameMaterial, OtherMaterial, Reversed };

std::optional<Mutant> copied_face(const Survey& survey, Random& random, Copy kind) {
  return first_that_plants(all_faces(survey), random, [&](FaceId face) -> std::optional<Mutant> {
    if (!survey.is_private(face)) return std::nullopt;
    Draft draft(survey.scene());
    DraftFace copy = draft.faces[face];
    if (kind != Copy::Reversed) copy.record.object = draft.add_object("planted");
    if (kind == Copy::OtherMaterial) copy.record.material = draft.add_material("planted");
    if (kind == Copy::Reversed) reverse(copy);
    draft.faces.push_back(std::move(copy));
    return Mutant{draft.scene(), {survey.box(face), {face, static_cast<FaceId>(draft.faces.size() - 1)}, {}}};
  });
}

std::optional<Mutant> copy_same(const Survey& survey, Random& random) {
  return copied_face(survey, random, Copy::SameMaterial);
}

std::optional<Mutant> copy_other(const Survey& survey, Random& random) {
  return copied_face(survey, random, Copy::OtherMaterial);
}

std::optional<Mutant> copy_reversed(const Survey& survey, Random& random) {
  return copied_face(survey, random, Copy::Reversed);
}

constexpr double kBoxShare = 0.35;  ///< half of a box's side over the room around it: its corners stay within 0.61

std::optional<Mutant> pushed_box(const Survey& survey, Random& random) {
  const auto spot = survey.spot(random, 6 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = kBoxShare * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const FaceId base = draft.add_box(spot->point, half * spot->u, half * spot->v, half * spot->normal, material,
                                    draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {spot->face, base}, {}}};
}

std::optional<Mutant> fin(const Survey& survey, Random& random) {
  const auto spot = survey.spot(random, 6 * survey.grain());
  if (!spot) return std::nullopt;
  const double reach = 0.5 * spot->clearance;
  Draft draft(survey.scene());
  const scene::MaterialId material = survey.scene().faces[spot->face].material;
  const FaceId face =
      draft.add_face({spot->point - reach * spot->u, spot->point + reach * spot->u, spot->point + reach * spot->normal},
                     material, draft.add_object("planted"));
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {spot->face, face}, {}}};
}

// A box that rests on a face in front of it. `imprinted`: the face has the contour of the box and a face below it.
std::optional<Mutant> resting(const Survey& survey, Random& random, bool imprinted) {
  const auto spot = survey.spot(random, 6 * survey.grain());
  if (!spot) return std::nullopt;
  const double half = kBoxShare * spot->clearance;
  Draft draft(survey.scene());
  const scene::Face record = survey.scene().faces[spot->face];
  const FaceId base = draft.add_box(spot->point + half * spot->normal, half * spot->u, half * spot->v,
                                    half * spot->normal, record.material, draft.add_object("planted"));
  if (imprinted) {
    DraftFace below = draft.faces[base];
    draft.faces[spot->face].loops.push_back(below.loops[0]);
    reverse(below);
    below.record = draft.faces[spot->face].record;
    draft.faces.push_back(std::move(below));
  }
  return Mutant{draft.scene(), {ball_box(spot->point, spot->clearance), {spot->face, base}, {}}};
}

std::optional<Mutant> resting_box(const Survey& survey, Random& random) { return resting(survey, random, true); }

std::optional<Mutant> box_without_contour(const Survey& survey, Random& random) {
  return resting(survey, random, false);
}

constexpr std::array<std::string_view, 1> kThrough{"RL211"};
constexpr std::array<std::string_view, 1> kHidden{"RL222"};

}  // namespace

std::span<const Mutator> contact_mutators() {
  static constexpr std::array<Mutator, 7> kMutators{{
      {"face twice, same material", "RL220", {}, copy_same},
      {"face twice, other material", "RL221", {}, copy_other},
      {"face twice, turned over", "RL114", kHidden, copy_reversed},
      {"box pushed through a face", "RL210", kThrough, pushed_box},
      {"fin standing in a face", "RL211", {}, fin},
      {"box at rest, no contour", "RL211", kHidden, box_without_contour},
      {"box at rest in its contour", "RL222", {}, resting_box},
  }};
  return kMutators;
}

}  // namespace rad::corpus
