// Filters one by one, and models between them.
#include <gtest/gtest.h>

#include "corpus/hard/kinds.h"
#include "repair/repair.h"
#include "scene/stage_record.h"
#include "tests/support/derived_scene.h"
#include "tests/support/random_scenes.h"
#include "tests/support/repaired_checks.h"

namespace rad::repair {
namespace {

using scene::Filter;
using scene::FilterSet;
using scene::Scene;

Repaired run(const Scene& scene, double tolerance, const FilterSet& filters) {
  RepairOptions options;
  options.tolerance = geom::ToleranceRequest{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  options.filters = filters;
  options.stage = true;
  return repair(scene, {}, options);
}

constexpr double kApart = 8;         // T: as far as either may lie from the input
constexpr double kAreaShare = 0.05;  // of all faces: bands of some T along their edges

double area_of(const scene::ConformingModel& model) {
  double sum = 0;
  for (const auto& t : tests::corners_of_result(model)) sum += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
  return sum;
}

// Whether the filters one by one could do without a second attempt; then they are compared with one run. That leaves as
// it is what nothing is wrong with, and they do not: the surfaces are the same, not the triangles.
bool chain_does_what_one_run_does(const Scene& scene, double tolerance) {
  Scene model = scene;
  Repaired result;
  for (const Filter filter : {Filter::Orient, Filter::Grouper, Filter::Isect, Filter::Coplanar, Filter::Orient}) {
    result = run(model, tolerance, {filter});
    EXPECT_EQ(result.refusal + result.impossible, "");
    if (result.model.faces.empty()) return false;
    if (filter == Filter::Isect && result.unresolved > 0) return false;
    EXPECT_TRUE(result.stage && result.stage->stage);
    model = *result.stage;
  }
  if (!tests::errors_in(result.model, model).empty()) return false;
  const Repaired whole = tests::repaired(scene, tolerance);
  // A larger T is not taken over from a file, nor is its lattice (scene/lattice_model.cpp).
  geom::Box box;
  for (const geom::LatticePoint& point : whole.model.points) box.add(whole.model.lattice.position(point));
  if (whole.model.tolerance.length > geom::kLargestRecordedShare * box.diagonal()) return false;
  const auto own = tests::corners_of_result(result.model), others = tests::corners_of_result(whole.model);
  EXPECT_LE(tests::farthest_corner(own, others), kApart * tolerance);
  EXPECT_LE(tests::farthest_corner(others, own), kApart * tolerance);
  EXPECT_NEAR(area_of(result.model) / area_of(whole.model), 1, kAreaShare);
  return true;
}

TEST(Filters, OneByOneAreOneRun) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    compared += chain_does_what_one_run_does(tests::fine_scene(seed), tests::kSceneTolerance) ? 1 : 0;
  }
  EXPECT_GE(compared, 25);
}

TEST(Filters, OneByOneAreOneRunOnHardScenes) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const corpus::HardScene soup = corpus::hard_scene(*corpus::hard_kind("soup"), seed);
    compared += chain_does_what_one_run_does(soup.scene, soup.tolerance) ? 1 : 0;
  }
  EXPECT_GE(compared, 10);
}

TEST(Filters, KeepOverlapsUntilCoplanar) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  sketch.face({{2, 1, 0}, {6, 1, 0}, {6, 3, 0}, {2, 3, 0}});
  const Scene scene = sketch.take();
  const auto area = [&](Filter last) {
    const Repaired result = run(scene, 1.0 / 64, FilterSet::until(last));
    double sum = 0;
    for (const auto& t : tests::corners_of_result(result.model)) {
      sum += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
    }
    return sum;
  };
  EXPECT_DOUBLE_EQ(area(Filter::Grouper), 24);
  EXPECT_DOUBLE_EQ(area(Filter::Isect), 24);
  EXPECT_DOUBLE_EQ(area(Filter::Coplanar), 20);
}

TEST(Filters, SayWhatCannotBeResolved) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  sketch.face({{2, 1, 0}, {6, 1, 0}, {6, 3, 0}, {2, 3, 0}});
  const Repaired result = run(sketch.take(), 1.0 / 64, {Filter::Coplanar});
  EXPECT_NE(result.impossible, "");
  EXPECT_TRUE(result.model.faces.empty());
}

}  // namespace
}  // namespace rad::repair
