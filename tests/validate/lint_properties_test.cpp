// What must hold of the judgement of any scene: the same however it is written down and wherever it stands.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "tests/support/finding_text.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_variants.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

using scene::Scene;
using Counts = std::map<std::string, std::uint64_t>;

constexpr std::uint64_t kScenes = 1500;

// Every other scene on the coarse grid.
Scene scene_of(std::uint64_t seed) { return seed % 2 == 0 ? tests::coarse_scene(seed) : tests::fine_scene(seed); }

LintResult judged(const Scene& scene, double tolerance = tests::kSceneTolerance) {
  LintOptions options;
  options.tolerance = geom::ToleranceRequest{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  return lint(scene, {}, options);
}

Counts counts_of(const Scene& scene, double tolerance = tests::kSceneTolerance) {
  return tests::counts_by_rule(judged(scene, tolerance).findings);
}

std::vector<std::string> texts_of(const LintResult& result, std::string (*text)(const scene::Finding&)) {
  std::vector<std::string> texts;
  for (const scene::Finding& finding : result.findings) texts.push_back(text(finding));
  return texts;
}

void expect_equal_figures(const LintResult& a, const LintResult& b) {
  EXPECT_EQ(a.tolerance.value().length, b.tolerance.value().length);
  EXPECT_EQ(a.pitch, b.pitch);
  EXPECT_EQ(a.lattice_origin, b.lattice_origin);
  EXPECT_EQ(a.figures.vertices, b.figures.vertices);
  EXPECT_EQ(a.figures.faces, b.figures.faces);
  EXPECT_EQ(a.figures.triangles, b.figures.triangles);
  EXPECT_EQ(a.figures.objects, b.figures.objects);
  EXPECT_EQ(a.figures.materials, b.figures.materials);
  EXPECT_EQ(a.figures.emitters, b.figures.emitters);
  EXPECT_EQ(a.checked, b.checked);
  EXPECT_EQ(a.refusal, b.refusal);
}

Scene mirrored(Scene scene) {
  for (geom::dvec3& p : scene.vertices) p.x = -p.x;
  for (const scene::Loop& loop : scene.loops) {
    const auto first = scene.corners.begin() + loop.first;
    std::reverse(first, first + loop.count);
  }
  return scene;
}

Scene doubled(const Scene& original, const geom::dvec3& by) {
  Scene scene = original;
  const auto vertices = static_cast<scene::VertexId>(original.vertices.size());
  for (const geom::dvec3& p : original.vertices) scene.vertices.push_back(p + by);
  for (const scene::VertexId corner : original.corners) scene.corners.push_back(vertices + corner);
  for (scene::Loop loop : original.loops) {
    loop.first += static_cast<std::uint32_t>(original.corners.size());
    scene.loops.push_back(loop);
  }
  for (scene::Face face : original.faces) {
    face.first_loop += static_cast<std::uint32_t>(original.loops.size());
    scene.faces.push_back(face);
  }
  return scene;
}

class LintProperty : public testing::Test {
 protected:
  template <typename Judge>
  static void for_each_scene(const Judge& judge) {
    for (std::uint64_t seed = 1; seed <= kScenes && !HasFailure(); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      judge(scene_of(seed));
    }
  }
};

TEST_F(LintProperty, ThreadsChangeNothing) {
  for_each_scene([](const Scene& scene) {
    const auto with_threads = [&](std::size_t count) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
      return judged(scene);
    };
    const LintResult one = with_threads(1), two = with_threads(2);
    EXPECT_EQ(texts_of(one, tests::text_in_full), texts_of(two, tests::text_in_full));
    expect_equal_figures(one, two);
  });
}

TEST_F(LintProperty, OrderInTheFileChangesNothing) {
  for_each_scene([](const Scene& scene) {
    const LintResult expected = judged(scene);
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      const LintResult other = judged(tests::rewritten(scene, seed));
      EXPECT_EQ(texts_of(other, tests::text_without_faces), texts_of(expected, tests::text_without_faces));
      expect_equal_figures(other, expected);
    }
  });
}

TEST_F(LintProperty, ScaleAndPlaceChangeNoCount) {
  for_each_scene([](const Scene& scene) {
    const Counts expected = counts_of(scene);
    EXPECT_EQ(counts_of(tests::scaled(scene, 7), tests::kSceneTolerance * 128), expected);
    EXPECT_EQ(counts_of(tests::scaled(scene, -30), std::ldexp(tests::kSceneTolerance, -30)), expected);
    EXPECT_EQ(counts_of(tests::moved(scene).value()), expected);
  });
}

// A mirrored face may be cut along another diagonal. A passage through it that is few T long and near its outline then
// falls into other pieces, each of which may run along an edge: RL211 instead of RL210, but never both or neither.
Counts with_passages_as_one(Counts counts) {
  counts["RL210"] += counts["RL211"];
  counts.erase("RL211");
  return counts;
}

TEST_F(LintProperty, MirroringChangesNoCount) {
  for_each_scene([](const Scene& scene) {
    EXPECT_EQ(with_passages_as_one(counts_of(mirrored(scene))), with_passages_as_one(counts_of(scene)));
  });
}

// RL113 is no fault of a place: from behind a facade one may see the other scene, or open space no more. Light, unit
// and axis are of the model as a whole, and so is the share of it that has no clear inside (RL105).
Counts of_places(Counts counts) {
  for (const char* rule : {"RL105", "RL113", "RL402", "RL501", "RL502", "RL503", "RL505"}) counts.erase(rule);
  return counts;
}

TEST_F(LintProperty, TwoScenesApartHaveTwiceTheFaults) {
  for_each_scene([](const Scene& scene) {
    Counts expected = of_places(counts_of(scene));
    for (auto& [rule, count] : expected) count *= 2;
    EXPECT_EQ(of_places(counts_of(doubled(scene, {512, -256, 128}))), expected);
  });
}

TEST_F(LintProperty, GroupingLosesNoViolation) {
  for_each_scene([](const Scene& scene) {
    LintOptions options;
    options.tolerance = geom::ToleranceRequest{tests::kSceneTolerance, geom::ToleranceRequest::Measure::FileUnits};
    options.group = false;
    EXPECT_EQ(tests::counts_by_rule(lint(scene, {}, options).findings), counts_of(scene));
  });
}

}  // namespace
}  // namespace rad::validate
