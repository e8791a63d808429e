// Repair as a whole: models, the ends of what a scene can be, and interruption.
#include "repair/repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "corpus/hard/kinds.h"
#include "readers/reader.h"
#include "tests/support/derived_scene.h"
#include "tests/support/repaired_checks.h"
#include "tests/support/scene_variants.h"
#include "tests/support/sketched_sheets.h"

namespace rad::repair {
namespace {

using scene::dvec3;
using scene::Scene;
using tests::sheet;
using tests::sketched;

constexpr double kTolerance = 1.0 / 64;

double area_of(const Repaired& result) {
  double sum = 0;
  for (const auto& t : tests::corners_of_result(result.model))
    sum += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
  return sum;
}

void expect_clean(const Repaired& result, const Scene& scene) {
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(result.unresolved, 0u);
  EXPECT_EQ(tests::errors_in(result.model, scene), std::vector<std::string>{});
}

std::uint64_t ledger_count(const Repaired& result, const std::string& operation) {
  std::uint64_t count = 0;
  for (const scene::LedgerEntry& entry : result.ledger) count += entry.operation == operation ? entry.count : 0;
  return count;
}

Scene read_model(const std::string& name) {
  return readers::read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/models" / name).scene;
}

class RepairedModel : public testing::TestWithParam<const char*> {};

TEST_P(RepairedModel, IsCleanAndStaysSo) {
  const Scene scene = read_model(GetParam());
  ASSERT_FALSE(scene.faces.empty());
  const Repaired result = repair(scene, {}, {});
  expect_clean(result, scene);
  const double tolerance = result.model.tolerance.length;
  const auto before = tests::corners_of_input(scene, tolerance), after = tests::corners_of_result(result.model);
  EXPECT_LE(tests::farthest_middle(before, after, 2 * tolerance), 8 * tolerance);
  EXPECT_LE(tests::farthest_corner(after, before), 8 * tolerance);
  const Scene written = scene::repaired_scene(result.model, scene, scene::Pieces::Triangles);
  EXPECT_TRUE(repair(written, {}, {}).untouched);
  const Scene shuffled = tests::rewritten(scene, 3);
  EXPECT_TRUE(tests::placed_triangles(repair(shuffled, {}, {}).model, shuffled) ==
              tests::placed_triangles(result.model, scene));
}

INSTANTIATE_TEST_SUITE_P(Models, RepairedModel,
                         testing::Values("furnished_room.obj", "lamp_post.obj", "lamp_post_repaired.obj",
                                         "two_room_flat.obj"),
                         [](const auto& name) {
                           const std::string text = name.param;
                           return text.substr(0, text.find('.'));
                         });

TEST(Repair, LeavesASoundModelUntouched) {
  tests::SceneSketch sketch;
  sketch.box({0, 0, 0}, {3, 2, 1});
  const Scene scene = sketch.take();
  const Repaired result = tests::repaired(scene, kTolerance);
  EXPECT_TRUE(result.untouched);
  EXPECT_TRUE(result.ledger.empty());
  EXPECT_EQ(result.model.faces.size(), 6u);
  EXPECT_DOUBLE_EQ(area_of(result), 22);
}

TEST(Repair, OfNothingIsNothing) {
  const Repaired result = tests::repaired(scene::empty_scene("scene.obj", "obj"), kTolerance);
  EXPECT_TRUE(result.model.faces.empty());
  EXPECT_EQ(result.unresolved, 0u);
}

TEST(Repair, OfWhatHasNoAreaIsNothing) {
  const Scene scene =
      sketched({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}, {{0, 0, 0}, {9, 9, 9}}});
  const Repaired result = tests::repaired(scene, kTolerance);
  EXPECT_TRUE(result.model.faces.empty());
  EXPECT_TRUE(result.model.triangles.empty());
}

TEST(Repair, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Scene scene = sketched({sheet(0, 0, 4, 4), {{0, 0, 1}, {1, 0, 1}, {nan, 1, 1}}});
  const Repaired result = tests::repaired(scene, kTolerance);
  EXPECT_DOUBLE_EQ(area_of(result), 16);
}

TEST(Repair, KeepsASingleTriangle) {
  const Scene scene = sketched({{{0, 0, 0}, {3, 0, 1}, {0, 2, 0}}});
  const Repaired result = tests::repaired(scene, kTolerance);
  expect_clean(result, scene);
  ASSERT_EQ(result.model.triangles.size(), 1u);
}

TEST(Repair, MakesOneOfManyEqualFaces) {
  const Scene scene = sketched(std::vector<std::vector<dvec3>>(30, sheet(0, 0, 4, 4)));
  const Repaired result = tests::repaired(scene, kTolerance);
  expect_clean(result, scene);
  EXPECT_EQ(result.model.faces.size(), 1u);
  EXPECT_DOUBLE_EQ(area_of(result), 16);
}

TEST(Repair, StandsHugeAndTinyCoordinates) {
  for (const int exponent : {-60, 60, 500}) {
    SCOPED_TRACE(exponent);
    const Scene scene = tests::scaled(sketched({sheet(0, 0, 4, 4), sheet(1, 1, 2, 2, kTolerance / 2)}), exponent);
    const Repaired result = tests::repaired(scene, std::ldexp(kTolerance, exponent));
    expect_clean(result, scene);
    EXPECT_EQ(result.model.faces.size(), 1u);
  }
  Scene far = sketched({sheet(0, 0, 4, 4), sheet(2, -1, 3, 1)});
  for (dvec3& p : far.vertices) p += dvec3(0x1p30, -0x1p31, 0x1p32);
  const Repaired result = tests::repaired(far, kTolerance);
  EXPECT_EQ(tests::errors_in(result.model, far), std::vector<std::string>{});
  EXPECT_NEAR(area_of(result), 17, 0.01);
}

TEST(Repair, DropsANeedleThatIsThinnerThanT) {
  const Scene scene = sketched({sheet(0, 0, 4, 4), {{10, 0, 0}, {14, 0, 0}, {12, kTolerance / 2, 0}}});
  const Repaired result = tests::repaired(scene, kTolerance);
  expect_clean(result, scene);
  EXPECT_NEAR(area_of(result), 16, 1e-9);
}

// Two corners in the wrong order: the lobes are equal, and what they enclose cancels. In the planes x = 0 and y = 0 the
// judge (validate/face_triangles.cpp) takes such a face for one without area, so it is lost there.
TEST(Repair, CutsARingThatCrossesItself) {
  const Scene scene =
      sketched({{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}}, {{9, 9, 0}, {9, 4, 5}, {9, 4, 0}, {9, 8, 3}}});
  const Repaired result = tests::repaired(scene, kTolerance);
  expect_clean(result, scene);
  EXPECT_GT(area_of(result), 8.5);
}

TEST(Repair, RefusesATooSmallTolerance) {
  const Repaired result = tests::repaired(sketched({sheet(0, 0, 4, 4)}), 1e-30);
  EXPECT_NE(result.refusal, "");
  EXPECT_TRUE(result.model.faces.empty());
}

TEST(Repair, PutsFacesTogetherAsTheyAre) {
  const Scene scene = sketched({sheet(0, 0, 1, 1), sheet(1, 0, 2, 1), sheet(0.5, 0.5, 1.5, 1.5, 0.001)});
  RepairOptions options;
  options.tolerance = geom::ToleranceRequest{kTolerance, geom::ToleranceRequest::Measure::FileUnits};
  options.filters = {};
  const Repaired result = repair(scene, {}, options);
  EXPECT_TRUE(result.untouched);
  EXPECT_TRUE(result.ledger.empty());
  EXPECT_EQ(result.model.faces.size(), 2u);
  EXPECT_NEAR(area_of(result), 3, 1e-9);
}

TEST(Repair, WritesWhatItDidIntoTheLedger) {
  const Scene scene =
      sketched({sheet(0, 0, 4, 4), sheet(1, 1, 2, 2, kTolerance / 2), sheet(4 + kTolerance / 2, 0, 8, 4)});
  const Repaired result = tests::repaired(scene, kTolerance);
  EXPECT_EQ(ledger_count(result, "weld"), 2u);
  EXPECT_GE(ledger_count(result, "snap-to-plane"), 4u);
  EXPECT_GE(ledger_count(result, "remove-covered-cell"), 2u);
  for (const scene::LedgerEntry& entry : result.ledger) EXPECT_LE(entry.largest_movement, 4 * kTolerance);
}

constexpr double kBusyTolerance = 0.01;

Scene busy_scene() { return corpus::hard_scene(*corpus::hard_kind("soup"), 4, 4).scene; }

// However late it is interrupted, it stops at the next step and hands back a model that is put together.
TEST(Repair, StopsWhenToldTo) {
  const Scene scene = busy_scene();
  RepairOptions options;
  options.tolerance = geom::ToleranceRequest{kBusyTolerance, geom::ToleranceRequest::Measure::FileUnits};
  int steps = 0;
  options.progress = [&](const char*, std::size_t) { return ++steps > 0; };
  EXPECT_FALSE(repair(scene, {}, options).interrupted);
  ASSERT_GT(steps, 4);
  for (int last = 1; last <= 4; ++last) {
    int called = 0;
    options.progress = [&](const char*, std::size_t) { return ++called < last; };
    const Repaired result = repair(scene, {}, options);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(called, last);
    EXPECT_FALSE(result.model.faces.empty());
  }
}

}  // namespace
}  // namespace rad::repair
