// Nothing is lost without a word: what closed or became flat stands in the ledger with its place.
#include "repair/losses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/derived_scene.h"
#include "tests/support/repaired_checks.h"

namespace rad::repair {
namespace {

using scene::dvec3;

constexpr double kTolerance = 1.0 / 64;

const scene::LedgerEntry* entry_of(const Repaired& result, std::string_view operation) {
  const auto found = std::ranges::find(result.ledger, operation, &scene::LedgerEntry::operation);
  return found == result.ledger.end() ? nullptr : &*found;
}

// A pane of the given thickness beside a block that is there twice, so that there is something to repair.
Repaired repaired_pane(double thickness) {
  tests::SceneSketch sketch;
  sketch.use("block", "stone");
  for (int i = 0; i < 2; ++i) sketch.box({6, 0, 0}, {8, 2, 2});
  sketch.use("pane", "glass");
  sketch.box({0, 0, 0}, {4, thickness, 3});
  return tests::repaired(sketch.take(), kTolerance);
}

TEST(Losses, NameTheFlattenedPane) {
  for (const double share : {0.3, 0.9, 1.1}) {
    SCOPED_TRACE(share);
    const Repaired result = repaired_pane(share * kTolerance);
    const scene::LedgerEntry* flat = entry_of(result, "flatten-plate");
    ASSERT_NE(flat, nullptr);
    EXPECT_GE(flat->count, 1u);
    EXPECT_NEAR(flat->places[0].area, 12, 0.1);
    EXPECT_LT(flat->places[0].point.x, 4);
  }
}

TEST(Losses, NameTheRim) {
  const scene::LedgerEntry* rim = entry_of(repaired_pane(0.3 * kTolerance), "drop-degenerate");
  ASSERT_NE(rim, nullptr);
  EXPECT_EQ(rim->count, 4u);
  EXPECT_EQ(rim->places.size(), 4u);
  // At 1.1 T the rim is a face, and closes.
  const scene::LedgerEntry* closed = entry_of(repaired_pane(1.1 * kTolerance), "close-face");
  ASSERT_NE(closed, nullptr);
  EXPECT_EQ(closed->count, 4u);
}

TEST(Losses, AreNoneWhereThePaneIsThickEnough) {
  const Repaired result = repaired_pane(4 * kTolerance);
  for (const char* operation : {"flatten-plate", "close-slit", "close-face", "drop-degenerate"}) {
    EXPECT_EQ(entry_of(result, operation), nullptr) << operation;
  }
}

TEST(Losses, NameTheClosedSlit) {
  // A U of 4 by 4 with a slit of half T down its middle, extruded by 3.
  const double half = kTolerance / 4;
  const std::vector<dvec3> u{{-2, 0, 0},   {2, 0, 0},     {2, 4, 0},     {half, 4, 0},
                             {half, 1, 0}, {-half, 1, 0}, {-half, 4, 0}, {-2, 4, 0}};
  tests::SceneSketch sketch;
  sketch.use("", "stone");
  std::vector<dvec3> top;
  for (const dvec3& p : u) top.push_back(p + dvec3(0, 0, 3));
  sketch.face(top);
  sketch.face({u.rbegin(), u.rend()});
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t next = (i + 1) % u.size();
    sketch.face({u[i], u[next], top[next], top[i]});
  }
  const scene::LedgerEntry* closed = entry_of(tests::repaired(sketch.take(), kTolerance), "close-slit");
  ASSERT_NE(closed, nullptr);
  EXPECT_NEAR(closed->places[0].area, 9, 0.1);
}

}  // namespace
}  // namespace rad::repair
