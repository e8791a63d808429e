// Every cell that Coplanar removes is told: who hid, who gave way, why, where and how much.
#include "repair/coplanar_log.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/derived_scene.h"
#include "tests/support/repaired_checks.h"

namespace rad::repair {
namespace {

using scene::dvec3;

constexpr double kTolerance = 1.0 / 64;

std::vector<dvec3> sheet(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

double area_of(const scene::ConformingModel& model) {
  double area = 0;
  for (const auto& t : tests::corners_of_result(model)) area += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
  return area;
}

TEST(CoplanarLog, TellsOfThePaperOnTheDesk) {
  tests::SceneSketch sketch;
  sketch.use("desk", "wood");
  sketch.face(sheet(0, 0, 8, 4));
  sketch.use("paper", "white");
  sketch.face(sheet(1, 1, 2, 2));
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  ASSERT_EQ(result.removals.size(), 1u);
  const scene::CoplanarRemoval& removal = result.removals[0];
  EXPECT_EQ(removal.winner.object, "paper");
  EXPECT_EQ(removal.loser.material, "wood");
  EXPECT_EQ(removal.loser.face.line, 1u);
  EXPECT_EQ(removal.rule, 'c');
  EXPECT_FALSE(removal.tie);
  EXPECT_NEAR(removal.area, 1, 1e-4);
  EXPECT_TRUE(removal.point.x > 1 && removal.point.x < 2 && removal.point.y > 1 && removal.point.y < 2);
}

// What was removed and what is left make up what there was, for any stack.
TEST(CoplanarLog, AccountsForAllArea) {
  tests::SceneSketch sketch;
  double before = 0;
  for (int i = 0; i < 5; ++i) {
    sketch.use("", "layer" + std::to_string(i));
    const double x = 2 * i, y = i % 2, width = 9 - i, depth = 3 + i;
    sketch.face(sheet(x, y, x + width, y + depth));
    before += width * depth;
  }
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  double removed = 0;
  std::uint64_t cells = 0;
  for (const scene::CoplanarRemoval& removal : result.removals) {
    removed += removal.area;
    cells += removal.count;
  }
  EXPECT_NEAR(area_of(result.model) + removed, before, 1e-3);
  const auto entry = std::ranges::find(result.ledger, "remove-covered-cell", &scene::LedgerEntry::operation);
  ASSERT_NE(entry, result.ledger.end());
  EXPECT_EQ(entry->count, cells);
}

TEST(CoplanarLog, CallsATieATie) {
  tests::SceneSketch sketch;
  sketch.use("wall", "blue");
  sketch.face(sheet(0, 0, 4, 4));
  sketch.use("wall", "amber");
  sketch.face(sheet(0, 0, 4, 4));
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  ASSERT_EQ(result.removals.size(), 1u);
  EXPECT_EQ(result.removals[0].rule, 'e');
  EXPECT_TRUE(result.removals[0].tie);
  EXPECT_EQ(result.removals[0].winner.material, "amber");
}

TEST(CoplanarLog, FindsNoFaultInRugOnRug) {
  tests::SceneSketch sketch;
  sketch.use("rug", "wool");
  sketch.face(sheet(0, 0, 4, 4));
  sketch.use("other rug", "wool");
  sketch.face(sheet(2, 2, 6, 6));
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  ASSERT_EQ(result.removals.size(), 1u);
  EXPECT_EQ(result.removals[0].rule, 'd');
  EXPECT_FALSE(result.removals[0].tie);
  EXPECT_NEAR(result.removals[0].area, 4, 1e-4);
}

TEST(CoplanarLog, HalvesADoubledModel) {
  tests::SceneSketch sketch;
  for (int i = 0; i < 2; ++i) sketch.box({0, 0, 0}, {3, 2, 1});
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  EXPECT_NEAR(area_of(result.model), 22, 1e-4);
  double removed = 0;
  for (const scene::CoplanarRemoval& removal : result.removals) {
    EXPECT_EQ(removal.rule, 'd');
    removed += removal.area;
  }
  EXPECT_NEAR(removed, 22, 1e-4);
}

// Opposite sides stay: a slab of no thickness, and a box on a floor with what it covers.
TEST(CoplanarLog, KeepsWhatLooksTheOtherWay) {
  tests::SceneSketch sketch;
  sketch.use("storey", "floor");
  sketch.face(sheet(0, 0, 8, 8));
  sketch.use("storey", "ceiling");
  sketch.face({{0, 8, 0}, {8, 8, 0}, {8, 0, 0}, {0, 0, 0}});
  sketch.use("box", "card");
  sketch.box({2, 2, 0}, {4, 4, 1});
  const Repaired result = tests::repaired(sketch.take(), kTolerance);
  // The bottom of the box and the ceiling look the same way: the smaller one is seen.
  ASSERT_EQ(result.removals.size(), 1u);
  EXPECT_EQ(result.removals[0].loser.material, "ceiling");
  EXPECT_NEAR(area_of(result.model), 64 + 60 + 16, 1e-3);
}

}  // namespace
}  // namespace rad::repair
