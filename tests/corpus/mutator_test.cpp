#include "corpus/mutate/mutator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus/generate/kept_files.h"
#include "corpus/generate/models.h"
#include "corpus/mutate/draft.h"
#include "tests/support/scene_invariants.h"
#include "writers/obj.h"

namespace rad::corpus {
namespace {

/// With what OBJ loses of materials and of the scene.
std::string texts_of(const scene::Scene& scene) {
  const writers::ObjText text = writers::obj_text(scene, "m.mtl");
  std::string out = text.obj + text.mtl + std::to_string(scene.metres_per_unit.value_or(0)) +
                    std::to_string(static_cast<int>(scene.up));
  for (const scene::Material& material : scene.materials) {
    const double highlight = material.specular.x + material.specular.y + material.specular.z;
    out += std::to_string(highlight) + " " + std::to_string(material.opacity) + " " +
           std::to_string(material.emission_cancelled) + " " + std::to_string(material.cut_out) + "\n";
  }
  return out;
}

std::string text_of(const scene::Scene& scene) { return writers::obj_text(scene, "m.mtl").obj; }

TEST(Draft, PutsTogetherWhatItTookApart) {
  const scene::Scene scene = furnished_room();
  EXPECT_EQ(text_of(Draft(scene).scene()), text_of(scene));
}

/// Some defects need a lamp in the model, others that there is none.
scene::Scene dark_flat() {
  scene::Scene scene = two_room_flat();
  for (scene::Material& material : scene.materials) material.emission = geom::dvec3(0);
  return scene;
}

/// In the flat, or where that has no place for the defect, in the dark one.
std::optional<Mutant> planted_in(const Survey& flat, const Survey& dark, const Mutator& mutator, std::uint64_t seed) {
  Random random(seed), again(seed);
  auto mutant = mutator.plant(flat, random);
  return mutant ? std::move(mutant) : mutator.plant(dark, again);
}

TEST(Mutators, ChangeTheSceneAndKeepItsInvariants) {
  const scene::Scene scene = two_room_flat(), dark_scene = dark_flat();
  const Survey survey(scene), dark(dark_scene);
  const std::string before = texts_of(scene);
  for (const Mutator& mutator : mutators()) {
    SCOPED_TRACE(mutator.name);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto mutant = planted_in(survey, dark, mutator, seed);
      ASSERT_TRUE(mutant) << "the flat has a place for every defect";
      EXPECT_EQ(tests::broken_invariant(mutant->scene), "");
      EXPECT_TRUE(texts_of(mutant->scene) != before);
      EXPECT_TRUE(mutant->planted.whole_model || !mutant->planted.region.empty());
      for (const FaceId face : mutant->planted.faces) EXPECT_LT(face, mutant->scene.faces.size());
    }
  }
  EXPECT_EQ(texts_of(scene), before);
}

TEST(Mutators, PlantTheSameWithTheSameSeed) {
  const scene::Scene scene = two_room_flat(), dark_scene = dark_flat();
  const Survey survey(scene), dark(dark_scene);
  for (const Mutator& mutator : mutators()) {
    SCOPED_TRACE(mutator.name);
    std::set<std::string> outcomes;
    for (int run = 0; run < 2; ++run) {
      const auto mutant = planted_in(survey, dark, mutator, 11);
      ASSERT_TRUE(mutant);
      outcomes.insert(text_of(mutant->scene));
    }
    EXPECT_EQ(outcomes.size(), 1u);
  }
}

TEST(TextMutators, NameTheLineTheyChange) {
  const std::string obj = kept_files()[0].bytes;
  for (const TextMutator& mutator : text_mutators()) {
    SCOPED_TRACE(mutator.name);
    Random random(3);
    const auto mutant = mutator.plant(obj, random);
    ASSERT_TRUE(mutant);
    ASSERT_EQ(mutant->planted.lines.size(), 1u);
    const auto changed = std::mismatch(obj.begin(), obj.end(), mutant->obj.begin(), mutant->obj.end());
    const auto line = 1 + std::count(obj.begin(), changed.first, '\n');
    EXPECT_EQ(mutant->planted.lines[0], static_cast<std::uint64_t>(line));
  }
}

TEST(Survey, KnowsWhatIsClosedAndAlone) {
  const scene::Scene scene = furnished_room();
  const Survey survey(scene);
  std::set<std::string> alone;
  for (scene::ObjectId id = 0; id < scene.objects.size(); ++id) {
    const ObjectFacts& facts = survey.objects()[id];
    if (facts.faces.empty()) continue;
    if (facts.alone) alone.insert(scene.objects[id]);
    // The panel of light and the room close each other.
    const bool open = scene.objects[id] == "light_panel" || scene.objects[id] == "room";
    EXPECT_EQ(facts.closed, !open) << scene.objects[id];
  }
  EXPECT_EQ(alone, std::set<std::string>{"lantern"});
}

}  // namespace
}  // namespace rad::corpus
