// The tree finds the pairs that comparing all with all finds.
#include "geom/box_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using tests::LatticeRandom;
using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

std::vector<LatticeBox> random_boxes(LatticeRandom& random, std::size_t count, std::int64_t range, std::int64_t size) {
  std::vector<LatticeBox> boxes(count);
  for (LatticeBox& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = static_cast<std::int32_t>(random.between(-range, range));
      box.high[axis] = box.low[axis] + static_cast<std::int32_t>(random.between(0, size));
    }
  }
  return boxes;
}

Pairs all_pairs(const std::vector<LatticeBox>& boxes) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[i].meets(boxes[j])) pairs.emplace(i, j);
    }
  }
  return pairs;
}

// Slots are asked for in blocks of `block`.
Pairs pairs_of(const BoxTree& tree, std::uint32_t block) {
  Pairs pairs;
  const auto size = static_cast<std::uint32_t>(tree.size());
  for (std::uint32_t first = 0; first < size; first += block) {
    tree.for_each_later_meeting(first, std::min(size, first + block), [&](std::uint32_t i, std::uint32_t j) {
      pairs.emplace(std::min(i, j), std::max(i, j));
    });
  }
  return pairs;
}

void expect_all_found(const std::vector<LatticeBox>& boxes) {
  const BoxTree tree(boxes);
  ASSERT_EQ(tree.size(), boxes.size());
  const std::set<std::uint32_t> items(tree.order().begin(), tree.order().end());
  ASSERT_EQ(items.size(), boxes.size()) << "every box is in one slot";
  const Pairs expected = all_pairs(boxes);
  for (const std::uint32_t block : {1u, 3u, 256u}) ASSERT_EQ(pairs_of(tree, block), expected);
}

void expect_queries_answered(const std::vector<LatticeBox>& boxes, const std::vector<LatticeBox>& queries) {
  const BoxTree tree(boxes);
  for (const LatticeBox& query : queries) {
    std::multiset<std::uint32_t> found, expected;
    tree.for_each_meeting(query, [&](std::uint32_t item) { found.insert(item); });
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].meets(query)) expected.insert(i);
    }
    ASSERT_EQ(found, expected);
  }
}

TEST(BoxTree, LeavesCoverTheSlotsAskedFor) {
  LatticeRandom random(7);
  const std::vector<LatticeBox> boxes = random_boxes(random, 300, 400, 40);
  const BoxTree tree(boxes);
  for (const auto& [begin, end] : {std::pair(0u, 300u), {17u, 18u}, {33u, 151u}, {20u, 20u}}) {
    std::vector<int> seen(boxes.size(), 0);
    tree.for_each_leaf(begin, end, [&](const LatticeBox& around, std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t slot = first; slot != last; ++slot) {
        ++seen[slot];
        const LatticeBox both = united(around, boxes[tree.order()[slot]]);
        ASSERT_EQ(both.low, around.low);
        ASSERT_EQ(both.high, around.high);
      }
    });
    for (std::uint32_t slot = 0; slot < seen.size(); ++slot) ASSERT_EQ(seen[slot], begin <= slot && slot < end ? 1 : 0);
  }
}

TEST(BoxTree, FindsAllPairsOfRandomBoxes) {
  LatticeRandom random(1);
  for (std::size_t count = 0; count < 70; ++count) {
    expect_all_found(random_boxes(random, count, 100, random.between(0, 60)));
  }
  expect_all_found(random_boxes(random, 1500, 400, 40));
}

TEST(BoxTree, FindsAllPairsOfLargeInput) {
  LatticeRandom random(2);
  expect_all_found(random_boxes(random, 9001, 3000, 120));
}

TEST(BoxTree, FindsAllPairsOfEqualBoxes) {
  expect_all_found(std::vector<LatticeBox>(300, LatticeBox{{1, 2, 3}, {4, 5, 6}}));
  expect_all_found(std::vector<LatticeBox>(300, LatticeBox{{7, 7, 7}, {7, 7, 7}}));
  LatticeRandom random(3);
  expect_all_found(random_boxes(random, 800, 2, 0));
}

TEST(BoxTree, HoldsBoxesBeyondTheLattice) {
  constexpr std::int32_t kFar = 1 << 25;
  expect_all_found({{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}},
                    {{kFar, kFar, kFar}, {kFar, kFar, kFar}},
                    {{-kFar, -kFar, -kFar}, {-kFar, -kFar, -kFar}}});
}

TEST(BoxTree, AnswersQueries) {
  LatticeRandom random(4);
  for (const std::size_t count : {0U, 1U, 2U, 5U, 333U}) {
    expect_queries_answered(random_boxes(random, count, 100, 20), random_boxes(random, 200, 120, 30));
  }
  expect_queries_answered(random_boxes(random, 6000, 2000, 50), random_boxes(random, 50, 2000, 500));
}

TEST(LatticeBoxes, TouchingCountsAsMeeting) {
  const LatticeBox box{{0, 0, 0}, {10, 10, 10}};
  EXPECT_TRUE(box.meets({{10, 10, 10}, {20, 20, 20}}));
  EXPECT_FALSE(box.meets({{11, 0, 0}, {20, 10, 10}}));
  EXPECT_FALSE(box.meets({{0, 0, -5}, {10, 10, -1}}));
}

TEST(LatticeBoxes, AreInflatedAndUnited) {
  const std::array<LatticePoint, 2> points{{{1, -5, 7}, {-2, 6, 7}}};
  const LatticeBox box = box_of(points, 3);
  EXPECT_EQ(box.low, (std::array<std::int32_t, 3>{-5, -8, 4}));
  EXPECT_EQ(box.high, (std::array<std::int32_t, 3>{4, 9, 10}));
  const LatticeBox both = united(box, {{0, 0, 0}, {20, 1, 1}});
  EXPECT_EQ(both.low, (std::array<std::int32_t, 3>{-5, -8, 0}));
  EXPECT_EQ(both.high, (std::array<std::int32_t, 3>{20, 9, 10}));
}

}  // namespace
}  // namespace rad::geom
