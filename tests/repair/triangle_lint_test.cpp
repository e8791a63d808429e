// Each kind of violation with what just breaks it and what just does not.
#include "repair/triangle_lint.h"

#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "geom/triangle_meeting.h"
#include "tests/repair/drawn_triangles.h"
#include "tests/repair/whole_lint.h"
#include "tests/support/lattice_random.h"

namespace rad::repair {

void PrintTo(const Violation& violation, std::ostream* out) {
  *out << "kind " << static_cast<int>(violation.kind) << " a " << violation.a << " b " << violation.b << " point "
       << violation.point;
}

namespace {

using Kind = ViolationKind;
using Violations = std::vector<Violation>;
using tests::lint_contacts;
using tests::lint_triangles;
using tests::TriangleSketch;

constexpr std::int64_t kTolerance = 32;

Violations lint(const TriangleSketch& sketch) { return lint_triangles(sketch.set(), kTolerance); }
Violations contacts(const TriangleSketch& sketch) { return lint_contacts(sketch.set(), kTolerance); }

TriangleSketch floor_sketch() {
  TriangleSketch sketch;
  sketch.add({0, 0, 0}, {6000, 0, 0}, {0, 6000, 0});
  return sketch;
}

TEST(TriangleLint, FindsNothingInNothing) {
  EXPECT_TRUE(lint({}).empty());
  EXPECT_TRUE(lint(floor_sketch()).empty());
}

TEST(TriangleLint, FindsAnIntersection) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({1000, 1000, -500}, {2000, 1000, -500}, {1500, 1000, 700});
  EXPECT_EQ(lint(sketch), (Violations{{Kind::Intersection, 0, 1, 0}}));
}

TEST(TriangleLint, FindsATouchThatNoPointTells) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({1000, 1000, 0}, {2000, 1000, 500}, {1500, 1000, 700});
  EXPECT_EQ(lint(sketch), (Violations{{Kind::Intersection, 0, 1, 0}}));
}

TEST(TriangleLint, PassesWhatSharesAnEdgeOrACorner) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({0, 0, 0}, {0, 6000, 0}, {0, 3000, 3000});
  sketch.add({0, 0, 0}, {-3000, 0, 0}, {-3000, -3000, 100});
  sketch.add({6000, 0, 0}, {0, 0, 0}, {3000, -3000, 0});
  EXPECT_TRUE(lint(sketch).empty());
  EXPECT_TRUE(contacts(sketch).empty());
}

TEST(TriangleLint, FindsAFold) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({0, 0, 0}, {6000, 0, 0}, {200, 2000, 0});
  const Violations found = lint(sketch);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0], (Violation{Kind::Intersection, 0, 1, 0}));
}

TEST(TriangleLint, TrustsAPlaneMapUnlessItFolds) {
  TriangleSketch sketch;
  sketch.add_in(0, {0, 0, 0}, {6000, 0, 0}, {0, 6000, 0});
  sketch.add_in(0, {1000, 1000, -500}, {2000, 1000, -500}, {1500, 1000, 700});
  EXPECT_TRUE(lint(sketch).empty());
  TriangleSet set = sketch.set();
  const std::array<std::uint8_t, 1> folded{1};
  set.folded = folded;
  EXPECT_EQ(lint_triangles(set, kTolerance).size(), 1u);
}

TEST(TriangleLint, FindsWhatNearlyCoincides) {
  for (const auto& [gap, violations] : {std::pair(31, 1u), {32, 1u}, {33, 0u}}) {
    TriangleSketch sketch = floor_sketch();
    sketch.add({1000, 1000, gap}, {2000, 1000, gap}, {1000, 2000, gap});
    const Violations found = lint(sketch);
    ASSERT_EQ(found.size(), violations) << gap;
    if (violations > 0) {
      EXPECT_EQ(found[0], (Violation{Kind::NearCoplanar, 1, 0, 0}));
    }
  }
}

TEST(TriangleLint, PassesWhatLooksOppositeWays) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({1000, 1000, 0}, {1000, 2000, 0}, {2000, 1000, 0});
  EXPECT_TRUE(lint(sketch).empty()) << "a box on the floor";
  sketch.add({3000, 1000, 20}, {3000, 2000, 20}, {4000, 1000, 20});
  EXPECT_TRUE(lint(sketch).empty()) << "a box just over it";
}

TEST(TriangleLint, FindsAPointOnAnEdge) {
  for (const auto& [gap, violations] : {std::pair(1, 1u), {32, 1u}, {33, 0u}}) {
    TriangleSketch sketch = floor_sketch();
    const LatticePoint tip{3000, -gap, 0};
    sketch.add(tip, {2500, -2000, 0}, {3500, -2000, 0});
    const Violations found = lint(sketch);
    ASSERT_EQ(found.size(), violations) << gap;
    if (violations > 0) {
      EXPECT_EQ(found[0], (Violation{Kind::PointOnEdge, 0, 0, sketch.point(tip)}));
    }
  }
}

// A point that near the end of an edge is a matter of welding.
TEST(TriangleLint, PassesAPointAtTheEndOfAnEdge) {
  for (const auto& [along, violations] : {std::pair(31, 0u), {33, 1u}}) {
    TriangleSketch sketch = floor_sketch();
    sketch.add({along, -20, 0}, {0, -2000, 0}, {1000, -2000, 0});
    EXPECT_EQ(lint(sketch).size(), violations) << along;
  }
}

// The floor's diagonal passes under a corner of a box: the contact is legal, the corner on the edge is not.
TEST(TriangleLint, FindsAPointAcrossAContact) {
  TriangleSketch sketch;
  sketch.add({0, 0, 0}, {6000, 0, 0}, {6000, 6000, 0});
  sketch.add({0, 0, 0}, {6000, 6000, 0}, {0, 6000, 0});
  sketch.add({2000, 2000, 0}, {3000, 4000, 0}, {4000, 3000, 0});
  EXPECT_EQ(lint(sketch), (Violations{{Kind::PointOnEdge, 0, 2, sketch.point({2000, 2000, 0})}}));
}

std::vector<std::array<LatticePoint, 3>> random_triangles(std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::vector<std::array<LatticePoint, 3>> all;
  while (all.size() < 14) {
    const std::array t{random.grid_point(3, 200), random.grid_point(3, 200), random.grid_point(3, 200)};
    if (!geom::collinear(t[0], t[1], t[2])) all.push_back(t);
  }
  return all;
}

bool lie_in_one_plane(const std::array<LatticePoint, 3>& a, const std::array<LatticePoint, 3>& b) {
  const geom::TrianglePlane plane(a[0], a[1], a[2]);
  return std::ranges::all_of(b, [&](const LatticePoint& p) { return std::abs(plane.distance(p)) <= kTolerance; });
}

TEST(TriangleLint, FindsTheIntersectionsThatBruteForceFinds) {
  std::size_t total = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    TriangleSketch sketch;
    for (const auto& t : random_triangles(seed)) sketch.add(t[0], t[1], t[2]);
    Violations expected, found;
    std::set<std::pair<std::uint32_t, std::uint32_t>> legal;
    for (std::uint32_t b = 0; b < sketch.triangles().size(); ++b) {
      for (std::uint32_t a = 0; a < b; ++a) {
        const auto s = sketch.corners(a), t = sketch.corners(b);
        if (lie_in_one_plane(s, t)) {
          legal.insert({a, b});  // may look opposite ways: tested above
        } else if (geom::meet_beyond_shared_corners(s, t)) {
          expected.push_back({Kind::Intersection, a, b, 0});
        }
      }
    }
    for (const Violation& violation : lint(sketch)) {
      if (violation.kind == Kind::Intersection && !legal.contains({violation.a, violation.b}))
        found.push_back(violation);
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << "seed " << seed;
    total += expected.size();
  }
  EXPECT_GT(total, 500u);
}

// Triangles come in three goes, and some leave: what is left is what one look at the rest finds.
TEST(TriangleLint, FindsTheSameStepByStep) {
  std::size_t violations = 0, contacts = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    TriangleSketch sketch;
    for (const auto& t : random_triangles(seed)) sketch.add(t[0], t[1], t[2]);
    std::vector<std::uint8_t> alive(sketch.triangles().size(), 0);
    TriangleSet set = sketch.set();
    set.alive = alive;
    TriangleLint step_by_step(kTolerance);
    for (std::uint32_t go = 0; go < 3; ++go) {
      for (std::uint32_t i = 0; i < alive.size(); i += 7) alive[i] = 0;
      std::vector<std::uint32_t> fresh;
      for (std::uint32_t i = go; i < alive.size(); i += 3) fresh.push_back(i);
      for (const std::uint32_t i : fresh) alive[i] = 1;
      step_by_step.update(set, fresh);
      if (go == 1) step_by_step.update_contacts(set);
    }
    step_by_step.update_contacts(set);
    EXPECT_EQ(step_by_step.violations(set), lint_triangles(set, kTolerance)) << "seed " << seed;
    EXPECT_EQ(step_by_step.contacts(), lint_contacts(set, kTolerance)) << "seed " << seed;
    violations += step_by_step.violations(set).size();
    contacts += step_by_step.contacts().size();
  }
  EXPECT_GT(violations, 500u);
  EXPECT_GT(contacts, 500u);
}

TEST(ContactLint, FindsACrossingAndPassesANeighbour) {
  TriangleSketch sketch = floor_sketch();
  sketch.add({1000, 1000, -500}, {2000, 1000, -500}, {1500, 1000, 700});
  EXPECT_EQ(contacts(sketch), (Violations{{Kind::Contact, 0, 1, 0}}));
  TriangleSketch passing = floor_sketch();
  passing.add({0, 0, 0}, {6000, 0, 0}, {3000, -3000, 3000});
  EXPECT_TRUE(contacts(passing).empty());
}

TEST(ContactLint, FindsAnEdgeThatTouchesWithinT) {
  for (const auto& [gap, violations] : {std::pair(30, 1u), {34, 0u}}) {
    TriangleSketch sketch = floor_sketch();
    sketch.add({1000, 1000, gap}, {2000, 1000, gap}, {1500, 1000, 2000});
    const Violations found = contacts(sketch);
    ASSERT_EQ(found.size(), violations) << gap;
    if (violations > 0) {
      EXPECT_EQ(found[0].kind, Kind::Contact);
    }
  }
}

TEST(ContactLint, FindsEdgesThatCrossAndPassesThoseThatDoNotMeet) {
  for (const auto& [gap, violations] : {std::pair(0, 1u), {1, 0u}}) {
    TriangleSketch sketch;
    sketch.add({0, 0, 0}, {4000, 0, 0}, {2000, 0, -3000});
    sketch.add({2000, -2000, gap}, {2000, 2000, gap}, {2000, 0, 3000});
    EXPECT_EQ(contacts(sketch).size(), violations) << gap;
  }
}

TEST(ContactLint, FindsAnOverlapOfOneFacingOnly) {
  TriangleSketch same = floor_sketch();
  same.add({1000, 1000, 20}, {2000, 1000, 20}, {1000, 2000, 20});
  EXPECT_EQ(contacts(same), (Violations{{Kind::NearCoplanar, 0, 1, 0}}));
  TriangleSketch opposite = floor_sketch();
  opposite.add({1000, 1000, 20}, {1000, 2000, 20}, {2000, 1000, 20});
  EXPECT_TRUE(contacts(opposite).empty());
}

}  // namespace
}  // namespace rad::repair
