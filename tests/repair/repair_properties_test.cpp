// What must hold of the repair of any scene: clean, complete, and the same however the scene is written down. The
// checks are those of rad_fuzz_repair, which runs them over as many seeds as one likes.
#include <gtest/gtest.h>

#include <iostream>

#include "corpus/hard/kinds.h"
#include "corpus/judge/repair_judge.h"
#include "tests/support/random_scenes.h"

namespace rad::repair {
namespace {

using corpus::RepairVerdict;

void expect_no_fault(const RepairVerdict& verdict) {
  for (const corpus::RepairFault& fault : verdict.faults) ADD_FAILURE() << fault.check << ": " << fault.what;
}

TEST(RepairProperty, HoldsOfCoarseScenes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_no_fault(corpus::judge_repair(tests::coarse_scene(seed), tests::kSceneTolerance, {}));
  }
}

TEST(RepairProperty, HoldsOfFineScenes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_no_fault(corpus::judge_repair(tests::fine_scene(seed), tests::kSceneTolerance, {}));
  }
}

class HardSceneProperty : public testing::TestWithParam<corpus::HardKind> {};

// Of each way in which scenes are placed some; see hard_scene().
constexpr std::array<std::uint64_t, 8> kSeeds{1, 2, 4, 6, 8, 11, 36, 40};

TEST_P(HardSceneProperty, HoldsOfIt) {
  for (const std::uint64_t seed : kSeeds) {
    const corpus::HardScene scene = corpus::hard_scene(GetParam(), seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + scene.variant);
    std::cout << GetParam() << " seed " << seed << scene.variant << '\n';
    expect_no_fault(corpus::judge_repair(scene.scene, scene.tolerance, {}));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HardSceneProperty,
                         testing::ValuesIn(corpus::hard_kinds().begin(), corpus::hard_kinds().end()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace rad::repair
