// What became of every face: sources, cuts, turns, movement with its bound.
#include "repair/face_history.h"

#include <gtest/gtest.h>

#include "tests/support/derived_scene.h"
#include "tests/support/random_scenes.h"
#include "tests/support/repaired_checks.h"
#include "tests/support/sketched_sheets.h"

namespace rad::repair {
namespace {

using scene::dvec3;
using scene::Scene;
using tests::sheet;
using tests::sketched;

constexpr double kTolerance = 1.0 / 64;

History history(const Scene& scene) { return history_of(scene, tests::repaired(scene, kTolerance).model); }

std::size_t count(const History& history, bool (*is)(const FaceHistory&)) {
  return static_cast<std::size_t>(std::ranges::count_if(history.faces, is));
}

TEST(FaceHistory, OfFacesThatAreLeftAsTheyWereSaysNothing) {
  const History result = history(sketched({sheet(0, 0, 4, 4), sheet(6, 0, 9, 4, 1)}));
  ASSERT_EQ(result.faces.size(), 2u);
  for (const FaceHistory& face : result.faces) {
    EXPECT_EQ(face.sources.size(), 1u);
    EXPECT_FALSE(face.cut || face.divided || face.turned || face.won || face.merged());
    EXPECT_EQ(face.moved, 0);
  }
  EXPECT_TRUE(result.gone.empty());
  EXPECT_EQ(result.result_to_input, 0);
  EXPECT_EQ(result.input_to_result, 0);
}

TEST(FaceHistory, TellsCutFacesAndMergedOnes) {
  // A wall stands across a sheet; two more sheets share an edge.
  const History result = history(sketched(
      {sheet(0, 0, 4, 4), {{2, 0, -1}, {2, 4, -1}, {2, 4, 1}, {2, 0, 1}}, sheet(10, 0, 12, 4), sheet(12, 0, 14, 4)}));
  EXPECT_EQ(count(result, [](const FaceHistory& face) { return face.cut; }), 4u);
  EXPECT_EQ(count(result, [](const FaceHistory& face) { return face.merged(); }), 1u);
  EXPECT_TRUE(result.gone.empty());
}

TEST(FaceHistory, TellsWhichFaceWonAndWhatIsGone) {
  const History result = history(sketched({sheet(0, 0, 4, 4), sheet(0, 0, 4, 4), {{9, 0, 0}, {10, 0, 0}, {11, 0, 0}}}));
  ASSERT_EQ(result.faces.size(), 1u);
  EXPECT_TRUE(result.faces[0].won);
  EXPECT_EQ(result.gone.size(), 2u);
  EXPECT_EQ(result.gone.back(), 2u);
}

TEST(FaceHistory, BoundsWhatMoved) {
  const History result = history(sketched({sheet(0, 0, 4, 4), sheet(4 + kTolerance / 2, 0, 8, 4)}));
  EXPECT_NEAR(result.result_to_input, kTolerance / 2, 1e-6);
  EXPECT_TRUE(result.far.empty());
}

// The bound holds at points inside the triangles too, and regions are listed exactly where something is beyond 4 T.
TEST(FaceHistory, TheBoundHoldsEverywhere) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = tests::fine_scene(seed);
    const Repaired result = tests::repaired(scene, tests::kSceneTolerance);
    if (result.model.faces.empty()) continue;
    const History found = history_of(scene, result.model);
    const auto before = tests::corners_of_input(scene, tests::kSceneTolerance);
    const double slack = result.model.lattice.pitch;
    double farthest = 0;
    for (const auto& t : tests::corners_of_result(result.model)) {
      for (const dvec3& probe : {t[0], tests::centroid(t), (t[1] + t[2]) / 2.0}) {
        farthest = std::max(farthest, tests::distance_to_any(probe, before));
      }
    }
    EXPECT_LE(farthest, found.result_to_input + slack);
    const double listed = std::max(found.result_to_input, found.input_to_result);
    EXPECT_EQ(found.far.empty(), listed <= kFarthestMove * result.model.tolerance.length);
  }
}

}  // namespace
}  // namespace rad::repair
