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

std::string text_of(const scene::Scene& scene) { return writers::obj_text(scene, "m.mtl").obj; }

TEST(Draft, PutsTogetherWhatItTookApart) {
  const scene::Scene scene = furnished_room();
  EXPECT_EQ(text_of(Draft(scene).scene()), text_of(scene));
}

TEST(Mutators, ChangeTheSceneAndKeepItsInvariants) {
  const scene::Scene scene = two_room_flat();
  const Survey survey(scene);
  const std::string before = text_of(scene);
  for (const Mutator& mutator : mutators()) {
    SCOPED_TRACE(mutator.name);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Random random(seed);
      const auto mutant = mutator.plant(survey, random);
      ASSERT_TRUE(mutant) << "the flat has a place for every defect";
      EXPECT_EQ(tests::broken_invariant(mutant->scene), "");
      EXPECT_NE(text_of(mutant->scene), before);
      EXPECT_FALSE(mutant->planted.region.empty());
      for (const FaceId face : mutant->planted.faces) EXPECT_LT(face, mutant->scene.faces.size());
    }
  }
  EXPECT_EQ(text_of(scene), before);
}

TEST(Mutators, PlantTheSameWithTheSameSeed) {
  const scene::Scene scene = two_room_flat();
  const Survey survey(scene);
  for (const Mutator& mutator : mutators()) {
    SCOPED_TRACE(mutator.name);
    std::set<std::string> outcomes;
    for (int run = 0; run < 2; ++run) {
      Random random(11);
      const auto mutant = mutator.plant(survey, random);
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
