#include "report/matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "report/pair_inputs.h"
#include "sample_reports.h"

namespace rad::report {
namespace {

using geom::dvec3;
using scene::Finding;

constexpr double kTolerance = 0.001;

/// A violation at a point of an object whose box starts at the origin.
Finding at(const dvec3& point, const std::string& fingerprint, const std::string& object = "floor") {
  Finding finding = samples::t_vertex(1, 0);
  finding.where.point = point;
  finding.where.bounds = std::array{point, point};
  finding.where.frame = dvec3{0, 0, 0};
  finding.where.objects = {object};
  finding.fingerprint = fingerprint;
  finding.count = 1;
  return finding;
}

Finding spread(const dvec3& low, const dvec3& high, std::uint64_t count, const std::string& object) {
  Finding finding = at(low, object + std::to_string(count), object);
  finding.where.bounds = std::array{low, high};
  finding.count = count;
  return finding;
}

Matching matching_of(const std::vector<Finding>& old, const std::vector<Finding>& now) {
  return match_findings(old, now, {.tolerance = kTolerance});
}

TEST(Matching, EqualFingerprintsMatchWhereverTheyAre) {
  const std::vector<Finding> old{at({0, 0, 0}, "a"), at({1, 0, 0}, "b")};
  const std::vector<Finding> now{at({9, 0, 0}, "b"), at({0, 0, 0}, "a")};
  const Matching matching = matching_of(old, now);
  ASSERT_EQ(matching.matches.size(), 2U);
  EXPECT_EQ(matching.matches[0].old.front(), &old[1]);
  EXPECT_EQ(matching.matches[0].now.front(), &now[0]);
}

TEST(Matching, OfEqualOnesTheNearestMatch) {
  const std::vector<Finding> old{at({0, 0, 0}, "a"), at({5, 0, 0}, "a-2")};
  const std::vector<Finding> now{at({5, 0, 0}, "a")};
  const Matching matching = matching_of(old, now);
  ASSERT_EQ(matching.matches.size(), 1U);
  EXPECT_EQ(matching.matches[0].old.front(), &old[1]);
  EXPECT_THAT(matching.only_old, testing::ElementsAre(&old[0]));
}

TEST(Matching, NoiseAcrossAStepIsNoChange) {
  const std::vector<Finding> old{at({1, 2, 3}, "a")};
  EXPECT_EQ(matching_of(old, {at({1, 2, 3.0005}, "b")}).matches.size(), 1U);
  EXPECT_EQ(matching_of(old, {at({1, 2, 3.5}, "b")}).matches.size(), 0U);
}

TEST(Matching, PlacesMoveWithTheirObject) {
  const std::vector<Finding> old{at({1, 2, 3}, "a")};
  Finding moved = at({5, 2, 3.0005}, "b");
  moved.where.frame = dvec3{4, 0, 0};
  EXPECT_EQ(matching_of(old, {moved}).matches.size(), 1U);
}

TEST(Matching, SamePlaceMatchesUnderAnotherName) {
  const std::vector<Finding> old{at({1, 2, 3}, "a", "floor")};
  EXPECT_EQ(matching_of(old, {at({1, 2, 3}, "b", "")}).matches.size(), 1U);
  EXPECT_EQ(matching_of(old, {at({1, 2, 3.05}, "b", "wall")}).matches.size(), 0U);
}

TEST(Matching, RulesAreNeverMixed) {
  Finding other = at({0, 0, 0}, "a");
  other.rule = "RL210";
  const Matching matching = matching_of({at({0, 0, 0}, "a")}, {other});
  EXPECT_EQ(matching.matches.size(), 0U);
  EXPECT_EQ(matching.only_old.size(), 1U);
}

TEST(Matching, FormatsThatKnowNoObjectsGroupDifferently) {
  const std::vector<Finding> old{spread({0, 0, 0}, {1, 1, 0}, 2, "a"), spread({0, 0, 0}, {3, 1, 0}, 3, "b")};
  const std::vector<Finding> now{spread({0, 0, 0}, {3, 1, 0}, 5, "")};
  const std::vector<Finding> more{spread({0, 0, 0}, {3, 1, 0}, 6, "")};
  const Matching matching = matching_of(old, now);
  ASSERT_EQ(matching.matches.size(), 1U);
  EXPECT_EQ(matching.matches[0].old.size(), 2U);
  EXPECT_EQ(matching_of(old, more).only_old.size(), 1U);
}

TEST(Matching, HalvesOfAQuadrilateralAreTheWhole) {
  const std::vector<Finding> old{spread({0, 0, 0}, {4, 1, 0}, 1, "a")};
  std::vector<Finding> now{spread({0, 0, 0}, {3, 1, 0}, 1, "b"), spread({1, 0, 0}, {4, 1, 0}, 1, "b")};
  now[1].fingerprint = "half";
  const MatchOptions options{.tolerance = kTolerance, .names_lost = true, .regrouped = true};
  ASSERT_EQ(match_findings(old, now, options).matches.size(), 1U);
  EXPECT_EQ(match_findings(old, now, options).matches[0].now.size(), 2U);
}

TEST(Matching, TrianglesMakeSeveralFindingsOfOne) {
  const std::vector<Finding> old{spread({0, 0, 0}, {4, 1, 0}, 9, "a")};
  std::vector<Finding> now{spread({0, 0, 0}, {4, 1, 0}, 8, "a"), spread({1, 0, 0}, {1, 1, 0}, 1, "a"),
                           spread({1, 0, 0}, {1, 1, 0}, 1, "b"), spread({9, 0, 0}, {9, 0, 0}, 1, "a")};
  for (std::size_t i = 0; i < now.size(); ++i) now[i].fingerprint = std::to_string(i);
  EXPECT_EQ(match_findings(old, now, {.tolerance = kTolerance}).only_now.size(), 3U);
  const Matching regrouped = match_findings(old, now, {.tolerance = kTolerance, .regrouped = true});
  ASSERT_EQ(regrouped.matches.size(), 1U);
  EXPECT_EQ(regrouped.matches[0].now.size(), 2U);
  EXPECT_THAT(regrouped.only_now, testing::ElementsAre(&now[2], &now[3]));
}

TEST(Matching, GrownClusterIsTheSame) {
  const std::vector<Finding> old{spread({0, 0, 0}, {4, 0, 0}, 5, "a")};
  EXPECT_EQ(matching_of(old, {spread({1, 0, 0}, {4, 0, 0}, 4, "a")}).matches.size(), 1U);
  EXPECT_EQ(matching_of(old, {spread({3, 0, 0}, {4, 0, 0}, 1, "a")}).matches.size(), 0U);
}

TEST(Matching, FindingsWithoutAPlace) {
  std::vector<Finding> old{samples::open_boundary(), samples::open_boundary()};
  old[0].fingerprint = "a";
  old[1].fingerprint = "b";
  std::vector<Finding> now = old;
  now[0].fingerprint = "c";
  EXPECT_EQ(matching_of(old, now).matches.size(), 2U);
  now[0].where.objects = {"other"};
  EXPECT_EQ(matching_of(old, now).matches.size(), 1U);
}

// A hundred thousand findings, shuffled and shaken: nothing is lost, and it does not take all day.
TEST(Matching, ManyFindings) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random() % 1'000'000) * 1e-3; };
  std::vector<Finding> old;
  for (int i = 0; i < 100'000; ++i) old.push_back(at({number(), number(), number()}, std::to_string(i)));
  std::vector<Finding> now = old;
  std::ranges::shuffle(now, random);
  for (std::size_t i = 0; i < now.size(); ++i) {
    for (dvec3& corner : *now[i].where.bounds) corner.x += 0.4 * kTolerance;
    if (i % 3 == 0) now[i].fingerprint += "x";
  }
  const auto start = std::chrono::steady_clock::now();
  const Matching matching = matching_of(old, now);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(matching.matches.size(), old.size());
  EXPECT_LT(taken.count(), 20);
  RecordProperty("seconds", std::to_string(taken.count()));
}

std::vector<std::pair<int, int>> pairs_of(const std::vector<std::string>& old, const std::vector<std::string>& now) {
  std::vector<std::pair<int, int>> pairs;
  for (const PathPair& pair : pair_paths(old, now)) {
    pairs.emplace_back(pair.old ? static_cast<int>(*pair.old) : -1, pair.now ? static_cast<int>(*pair.now) : -1);
  }
  return pairs;
}

TEST(PairPaths, OnlyOnesAreAPair) {
  EXPECT_THAT(pairs_of({"a.obj"}, {"x/b.glb"}), testing::ElementsAre(std::pair(0, 0)));
}

TEST(PairPaths, FoldersAndSuffixesMayDiffer) {
  EXPECT_THAT(
      pairs_of({"v1/a/room.obj", "v1/b/room.obj", "v1/hall.obj"}, {"v2/hall.glb", "v2/b/room.obj", "v2/a/room.obj"}),
      testing::ElementsAre(std::pair(2, 0), std::pair(1, 1), std::pair(0, 2)));
}

TEST(PairPaths, NewAndGoneFilesStandAlone) {
  EXPECT_THAT(pairs_of({"a.obj", "b.obj"}, {"b.obj", "c.obj"}),
              testing::ElementsAre(std::pair(1, 0), std::pair(-1, 1), std::pair(0, -1)));
}

TEST(PairPaths, SameNameInTwoFormats) {
  EXPECT_THAT(pairs_of({"a.obj", "a.glb"}, {"a.glb", "a.ply"}), testing::ElementsAre(std::pair(1, 0), std::pair(0, 1)));
}

}  // namespace
}  // namespace rad::report
