// Welding: separation, bounded movement, and the same whatever the order of the points.
#include "repair/weld.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "geom/tolerance.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 100;  // pitches
constexpr double kWeld = geom::kWeldRatio * kTolerance;
constexpr double kFarthest = kTolerance / 2 + kWeld;

using Points = std::vector<LatticePoint>;

// A point on the x axis, in weld distances.
LatticePoint on_axis(double welds) { return {static_cast<std::int32_t>(std::lround(welds * kWeld)), 0, 0}; }

double distance(const LatticePoint& a, const LatticePoint& b) {
  return glm::distance(geom::as_vector(a), geom::as_vector(b));
}

Points welded(const Points& points) {
  Points result;
  for (const std::uint32_t id : weld(points, kTolerance)) result.push_back(points[id]);
  return result;
}

std::set<LatticePoint> survivors(const Points& points) {
  const Points result = welded(points);
  return {result.begin(), result.end()};
}

Points in_order(const Points& points, const std::vector<std::uint32_t>& order) {
  Points result;
  for (const std::uint32_t i : order) result.push_back(points[i]);
  return result;
}

// Noise around few places, so that clusters, chains and pairs at every distance about the weld distance occur.
Points noisy_points(std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  const std::int64_t noise = random.between(5, 250);
  Points points;
  const std::int64_t places = random.between(1, 8);
  for (std::int64_t i = 0; i < places; ++i) {
    const LatticePoint place = random.grid_point(3, 150);
    for (std::int64_t count = random.between(1, 15); count > 0; --count) {
      const std::int64_t x = random.between(-noise, noise), y = random.between(-noise, noise);
      points.push_back(tests::moved_by(place, x, y, random.between(-noise, noise)));
      if (random.one_in(4)) points.push_back(points.back());
    }
  }
  return points;
}

TEST(Weld, LeavesPointsThatAreApart) {
  const Points points{on_axis(0), on_axis(1.01), on_axis(2.02), {0, 500, 0}};
  EXPECT_EQ(welded(points), points);
}

TEST(Weld, GivesEqualPointsOneRepresentative) {
  const Points points(1000, LatticePoint{7, -8, 9});
  const auto result = weld(points, kTolerance);
  EXPECT_EQ(std::set<std::uint32_t>(result.begin(), result.end()).size(), 1u);
}

TEST(Weld, TakesNothingFromNothing) { EXPECT_TRUE(weld({}, kTolerance).empty()); }

TEST(Weld, KeepsTheMoreFrequentOfTwo) {
  const LatticePoint rare{0, 0, 0}, frequent{30, 0, 0};
  EXPECT_EQ(survivors({rare, frequent, frequent}), std::set{frequent});
  EXPECT_EQ(survivors({rare, rare, frequent}), std::set{rare});
  EXPECT_EQ(survivors({frequent, rare}), std::set{rare});  // the first in space among equals
}

TEST(Weld, DoesNotCollapseAChain) {
  Points chain;
  for (int i = 0; i < 40; ++i) chain.push_back(on_axis(0.9 * i));
  const Points result = welded(chain);
  EXPECT_EQ(std::set(result.begin(), result.end()).size(), 20u);
  for (std::size_t i = 0; i < chain.size(); ++i) EXPECT_LE(distance(chain[i], result[i]), kWeld);
}

TEST(Weld, JoinsThePairThatTwoClustersWouldTear) {
  const Points points{on_axis(0), on_axis(0.99), on_axis(1.01), on_axis(2)};
  const Points result = welded(points);
  EXPECT_EQ(result[1], result[2]);
}

TEST(Weld, SeesPairsOnEitherSideOfACellBorder) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int border : {-2, -1, 0, 1, 2}) {
      const auto at = [&](double cells) {
        std::array<std::int32_t, 3> p{5, 5, 5};
        p[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(std::floor((border + cells) * kWeld));
        return LatticePoint{p[0], p[1], p[2]};
      };
      EXPECT_EQ(survivors({at(-0.1), at(0.1)}).size(), 1u) << axis << ' ' << border;
      EXPECT_EQ(survivors({at(-0.45), at(0.5)}).size(), 1u) << axis << ' ' << border;
      EXPECT_EQ(survivors({at(-0.55), at(0.5)}).size(), 2u) << axis << ' ' << border;
    }
  }
}

TEST(Weld, LeavesALatticeOfPointsJustBeyondReach) {
  Points apart, near;
  for (int i = 0; i < 216; ++i) {
    const int x = i % 6, y = i / 6 % 6, z = i / 36;
    apart.push_back({x * 118, y * 118, z * 118});
    near.push_back({x * 115, y * 115, z * 115});
  }
  EXPECT_EQ(survivors(apart).size(), apart.size());
  EXPECT_LT(survivors(near).size(), near.size() / 2 + 1);
}

RC_GTEST_PROP(WeldProperty, SeparatesAndMovesNoPointFar, (std::uint64_t seed)) {
  const Points points = noisy_points(seed);
  const Points result = welded(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    RC_ASSERT(distance(points[i], result[i]) <= kFarthest);
    for (std::size_t j = 0; j < i; ++j) RC_ASSERT(result[i] == result[j] || distance(result[i], result[j]) > kWeld);
  }
}

RC_GTEST_PROP(WeldProperty, HasNothingLeftToDo, (std::uint64_t seed)) {
  const Points result = welded(noisy_points(seed));
  RC_ASSERT(welded(result) == result);
}

RC_GTEST_PROP(WeldProperty, TakesNoHeedOfTheOrder, (std::uint64_t seed)) {
  const Points points = noisy_points(seed);
  std::mt19937 random(static_cast<std::uint32_t>(seed));
  const auto order = tests::shuffled(points.size(), random);
  RC_ASSERT(welded(in_order(points, order)) == in_order(welded(points), order));
}

RC_GTEST_PROP(WeldProperty, RepresentsEachRepresentativeByItself, (std::uint64_t seed)) {
  const Points points = noisy_points(seed);
  const auto result = weld(points, kTolerance);
  for (const std::uint32_t id : result) RC_ASSERT(points[result[id]] == points[id]);
}

}  // namespace
}  // namespace rad::repair
