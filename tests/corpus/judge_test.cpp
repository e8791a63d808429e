// The judges of repair must themselves be right: they are held against exact constructions and against planted faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus/hard/kinds.h"
#include "corpus/judge/exact_lint.h"
#include "corpus/judge/exact_meeting.h"
#include "corpus/judge/fidelity.h"
#include "corpus/judge/repair_judge.h"
#include "corpus/judge/shrink.h"
#include "tests/support/exact_meeting.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_invariants.h"
#include "writers/obj.h"

namespace rad::corpus {
namespace {

using geom::LatticePoint;

std::string text_of(const scene::Scene& scene) { return writers::obj_text(scene, "m.mtl").obj; }

bool same_triangle(const TriangleCorners& a, const TriangleCorners& b) {
  return std::ranges::all_of(a, [&](const LatticePoint& p) { return std::ranges::find(b, p) != b.end(); });
}

TriangleCorners random_triangle(tests::LatticeRandom& random) {
  while (true) {
    const TriangleCorners t{random.grid_point(2, 1), random.grid_point(2, 1), random.grid_point(2, 1)};
    if (!has_no_area(t)) return t;
  }
}

// Beyond common corners and edges, as CGAL constructs it.
bool meet_beyond(const TriangleCorners& a, const TriangleCorners& b) {
  const auto shared = [&](const LatticePoint& p) { return std::ranges::find(b, p) != b.end(); };
  const auto common = std::ranges::count_if(a, shared);
  switch (tests::exact_meeting(a, b)) {
    case tests::Meeting::Apart:
    case tests::Meeting::CommonVertex:
      return false;
    case tests::Meeting::AlongBothEdges:
      return common < 2;
    default:
      return true;
  }
}

TEST(ExactMeeting, AgreesWithExactConstructions) {
  tests::LatticeRandom random(5);
  int met = 0, judged = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const TriangleCorners a = random_triangle(random), b = random_triangle(random);
    if (same_triangle(a, b)) continue;
    ++judged;
    met += meet_improperly(a, b) ? 1 : 0;
    ASSERT_EQ(meet_improperly(a, b), meet_beyond(a, b)) << "trial " << trial;
    ASSERT_EQ(meet_improperly(a, b), meet_improperly(b, a)) << "trial " << trial;
  }
  EXPECT_GT(met, judged / 10);
  EXPECT_LT(met, judged - judged / 10);
}

LatticeTriangles triangles(const std::vector<LatticePoint>& points,
                           const std::vector<std::array<std::uint32_t, 3>>& corners) {
  return {points, corners};
}

constexpr double kT = 10;

TEST(ExactLint, PassesTwoTrianglesThatShareAnEdge) {
  EXPECT_TRUE(
      exact_lint(triangles({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {100, 100, 0}}, {{0, 1, 2}, {1, 3, 2}}), kT).clean());
}

TEST(ExactLint, CountsWhatIsWrong) {
  const std::vector<LatticePoint> floor{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}};
  const auto with = [&](std::vector<LatticePoint> more, std::array<std::uint32_t, 3> corners) {
    std::vector<LatticePoint> points = floor;
    points.insert(points.end(), more.begin(), more.end());
    return exact_lint(triangles(points, {{0, 1, 2}, corners}), kT);
  };
  EXPECT_EQ(with({{200, 0, 0}, {300, 0, 0}, {400, 0, 0}}, {3, 4, 5}).degenerate, 1u);
  EXPECT_EQ(with({}, {1, 2, 0}).duplicates, 1u);
  EXPECT_TRUE(with({}, {2, 1, 0}).clean()) << "back to back";
  EXPECT_EQ(with({{20, 20, -50}, {20, 20, 50}, {300, 300, 50}}, {3, 4, 5}).intersections, 1u);
  EXPECT_EQ(with({{10, 10, 5}, {40, 10, 5}, {10, 40, 5}}, {3, 4, 5}).overlaps, 1u);
  EXPECT_TRUE(with({{10, 10, 11}, {40, 10, 11}, {10, 40, 11}}, {3, 4, 5}).clean()) << "farther than T";
  EXPECT_EQ(with({{50, -9, 0}, {60, -90, 0}, {70, -90, 50}}, {3, 4, 5}).t_vertices, 1u);
  EXPECT_TRUE(with({{50, -11, 0}, {60, -90, 0}, {70, -90, 50}}, {3, 4, 5}).clean());
}

TEST(Fidelity, MeasuresWhatIsMissing) {
  const PlacedTriangle large{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}}, lifted{{{0, 0, 2}, {10, 0, 2}, {0, 10, 2}}};
  EXPECT_DOUBLE_EQ(farthest_deep_point({large}, {lifted}, 1), 2);
  EXPECT_DOUBLE_EQ(farthest_point({large}, {lifted}), 2);
  EXPECT_EQ(farthest_deep_point({large}, {large}, 1), 0);
  EXPECT_EQ(farthest_deep_point({large}, {}, 4), 0) << "nowhere that deep";
  EXPECT_EQ(farthest_deep_point({large}, {}, 1), INFINITY);
  geom::Box all;
  all.add({0, 0, 0});
  all.add({10, 10, 0});
  EXPECT_EQ(farthest_point({large}, {lifted}, all), 0) << "all of it is excepted";
}

TEST(HardKinds, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const HardKind& kind : hard_kinds()) EXPECT_TRUE(names.insert(kind.name).second) << kind;
  EXPECT_EQ(hard_kind("no such kind"), nullptr);
  EXPECT_EQ(hard_kind("comb")->name, "comb");
}

TEST(HardKinds, DrawTheSameWithTheSameSeed) {
  for (const HardKind& kind : hard_kinds()) {
    SCOPED_TRACE(kind.name);
    std::set<std::string> texts;
    for (std::uint64_t seed = 1; seed <= 64; ++seed) {
      const HardScene scene = hard_scene(kind, seed);
      EXPECT_EQ(tests::broken_invariant(scene.scene), "") << "seed " << seed;
      texts.insert(text_of(scene.scene));
    }
    EXPECT_GT(texts.size(), 20u);
    EXPECT_TRUE(texts.contains(text_of(hard_scene(kind, 64).scene)));
    EXPECT_GE(hard_scene(kind, 9, 3).scene.faces.size(), hard_scene(kind, 9, 1).scene.faces.size());
  }
}

TEST(RepairJudge, FindsNoFaultWithASquareAndNamesARefusal) {
  HardSketch sketch(1, 0.01, 1);
  sketch.add(rectangle(0, 0, 1, 1, 0), 0);
  const RepairVerdict good = judge_repair(sketch.scene(), 0.01, {});
  EXPECT_TRUE(good.faults.empty());
  EXPECT_TRUE(good.was_clean);
  const RepairVerdict refused = judge_repair(sketch.scene(), 1e-12, {});
  ASSERT_EQ(refused.faults.size(), 1u);
  EXPECT_EQ(refused.faults[0].check, "ends");
}

// Fails wherever two faces have the height of two faults.
TEST(Shrink, LeavesTheFewestFacesAndRoundPlaces) {
  HardSketch sketch(1, 0.01, 1);
  for (int i = 0; i < 40; ++i) sketch.add(rectangle(i, 0, i + 0.7391, 1.2345, i == 13 || i == 29 ? 5.25 : 0), 0);
  const scene::Scene small = shrunken(sketch.scene(), [](const scene::Scene& scene) {
    return std::ranges::count_if(scene.faces, [&](const scene::Face& face) {
             const auto corners = scene.corners_of(scene.loops[face.first_loop]);
             return scene.vertices[corners[0]].z > 5.1;
           }) == 2;
  });
  ASSERT_EQ(small.faces.size(), 2u);
  EXPECT_EQ(small.vertices.size(), 8u);
  EXPECT_EQ(tests::broken_invariant(small), "");
  for (const dvec3& p : small.vertices) EXPECT_NEAR(100 * p.x, std::round(100 * p.x), 1e-9);
}

}  // namespace
}  // namespace rad::corpus
