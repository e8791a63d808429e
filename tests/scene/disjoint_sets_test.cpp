// Sets and their representatives do not depend on the order of unions.
#include "scene/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace rad::scene {
namespace {

using Union = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::uint32_t> representatives(std::size_t count, const std::vector<Union>& unions) {
  DisjointSets sets(count);
  for (const auto& [a, b] : unions) sets.unite(a, b);
  std::vector<std::uint32_t> result(count);
  for (std::uint32_t i = 0; i < count; ++i) result[i] = sets.find(i);
  return result;
}

// The smallest member that can be reached, found by spreading labels until nothing changes.
std::vector<std::uint32_t> smallest_reachable(std::size_t count, const std::vector<Union>& unions) {
  std::vector<std::uint32_t> label(count);
  for (std::uint32_t i = 0; i < count; ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : unions) {
      const std::uint32_t least = std::min(label[a], label[b]);
      changed = changed || label[a] != least || label[b] != least;
      label[a] = label[b] = least;
    }
  }
  return label;
}

TEST(DisjointSets, StartApart) {
  DisjointSets sets(3);
  EXPECT_EQ(sets.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
  EXPECT_EQ(DisjointSets(0).size(), 0U);
}

TEST(DisjointSets, RepresentativeIsTheSmallestMember) {
  DisjointSets sets(6);
  sets.unite(5, 4);
  sets.unite(4, 2);
  sets.unite(2, 2);
  EXPECT_EQ(sets.find(5), 2U);
  sets.unite(0, 5);
  EXPECT_EQ(sets.find(4), 0U);
  EXPECT_EQ(sets.find(3), 3U);
}

TEST(DisjointSets, DoNotDependOnTheOrderOfUnions) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = 1 + random() % 60;
    std::vector<Union> unions(random() % 60);
    for (Union& u : unions) u = {random() % count, random() % count};
    const auto expected = smallest_reachable(count, unions);
    for (int order = 0; order < 4; ++order) {
      ASSERT_EQ(representatives(count, unions), expected);
      std::shuffle(unions.begin(), unions.end(), random);
      for (Union& u : unions) {
        if (random() % 2 == 0) std::swap(u.first, u.second);
      }
    }
  }
}

TEST(DisjointSets, FollowLongChains) {
  constexpr std::uint32_t kCount = 100000;
  DisjointSets sets(kCount);
  for (std::uint32_t i = kCount - 1; i > 0; --i) sets.unite(i, i - 1);
  EXPECT_EQ(sets.find(kCount - 1), 0U);
}

}  // namespace
}  // namespace rad::scene
