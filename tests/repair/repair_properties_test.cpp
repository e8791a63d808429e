// What must hold of the repair of any scene: clean, complete, and the same however the scene is written down.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/support/hard_scenes.h"
#include "tests/support/random_scenes.h"
#include "tests/support/repaired_checks.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

using scene::Scene;

// Points may move by 4 T, and what is merged locally by some more.
constexpr double kLossBound = 8;  // T
// What is thinner may close to a line.
constexpr double kThinBound = 2;  // T

Repaired repaired_with_threads(const Scene& scene, double tolerance, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return tests::repaired(scene, tolerance);
}

// Lists, numbers and ledger.
void expect_same_bytes(const Repaired& a, const Repaired& b) {
  EXPECT_TRUE(a.model.points == b.model.points);
  EXPECT_TRUE(a.model.corners == b.model.corners);
  EXPECT_TRUE(a.model.inner_edges == b.model.inner_edges);
  EXPECT_TRUE(a.model.triangles == b.model.triangles);
  ASSERT_EQ(a.model.faces.size(), b.model.faces.size());
  for (std::size_t i = 0; i < a.model.faces.size(); ++i) {
    EXPECT_EQ(a.model.faces[i].source, b.model.faces[i].source);
    EXPECT_EQ(a.model.faces[i].first_triangle, b.model.faces[i].first_triangle);
    EXPECT_EQ(a.model.faces[i].first_loop, b.model.faces[i].first_loop);
  }
  ASSERT_EQ(a.ledger.size(), b.ledger.size());
  for (std::size_t i = 0; i < a.ledger.size(); ++i) {
    EXPECT_EQ(a.ledger[i].operation, b.ledger[i].operation);
    EXPECT_EQ(a.ledger[i].count, b.ledger[i].count);
    EXPECT_EQ(a.ledger[i].largest_movement, b.ledger[i].largest_movement);
  }
}

void expect_clean(const Repaired& result, const Scene& scene) {
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(result.unresolved, 0u);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(tests::errors_in(result.model, scene), std::vector<std::string>{});
}

void expect_nothing_lost(const Repaired& result, const Scene& scene, double tolerance) {
  const auto before = tests::corners_of_input(scene, tolerance);
  const auto after = tests::corners_of_result(result.model);
  EXPECT_LE(tests::farthest_middle(before, after, kThinBound * tolerance), kLossBound * tolerance);
  if (!after.empty()) {
    EXPECT_LE(tests::farthest_corner(after, before), kLossBound * tolerance);
  }
}

void expect_repair_again_changes_nothing(const Repaired& result, const Scene& scene) {
  const Scene written = scene::repaired_scene(result.model, scene, scene::Pieces::Triangles);
  const Repaired again = tests::repaired(written, result.model.tolerance.length);
  EXPECT_TRUE(again.untouched);
  EXPECT_TRUE(tests::placed_triangles(again.model, written) == tests::placed_triangles(result.model, scene));
}

void expect_good_repair(const Scene& scene, double tolerance) {
  const Repaired result = repaired_with_threads(scene, tolerance, 1);
  expect_clean(result, scene);
  expect_nothing_lost(result, scene, tolerance);
  expect_same_bytes(repaired_with_threads(scene, tolerance, 2), result);
  const Scene shuffled = tests::rewritten(scene, 7);
  EXPECT_TRUE(tests::placed_triangles(tests::repaired(shuffled, tolerance).model, shuffled) ==
              tests::placed_triangles(result.model, scene))
      << "depends on the order of faces or vertices";
  expect_repair_again_changes_nothing(result, scene);
}

TEST(RepairProperty, HoldsOfCoarseScenes) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_good_repair(tests::coarse_scene(seed), tests::kSceneTolerance);
  }
}

TEST(RepairProperty, HoldsOfFineScenes) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_good_repair(tests::fine_scene(seed), tests::kSceneTolerance);
  }
}

class HardSceneProperty : public testing::TestWithParam<tests::HardKind> {};

TEST_P(HardSceneProperty, HoldsOfIt) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_good_repair(tests::hard_scene(GetParam(), seed), tests::kHardTolerance);
  }
}

// T is ten pitches where the scene is large enough for such a record to be taken over.
TEST_P(HardSceneProperty, HoldsOnACoarseLattice) {
  for (std::uint64_t seed = 301; seed <= 310; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = tests::hard_scene(GetParam(), seed);
    scene.recorded = scene::RecordedLattice{{0x1p-10, {0, 0, 0}}, tests::kHardTolerance};
    expect_good_repair(scene, tests::kHardTolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HardSceneProperty, testing::ValuesIn(tests::kHardKinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace rad::repair
