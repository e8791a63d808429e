// Directed edges come together to loops that visit each of their points once.
#include "repair/outline_loops.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rad::repair {
namespace {

using Loop = std::vector<PointId>;
using Loops = std::vector<Loop>;

// Of closed walks, each given by its points.
Loops loops_of(const Loops& walks, OutlineLoops& outline) {
  std::vector<std::array<PointId, 2>> edges;
  for (const Loop& walk : walks) {
    for (std::size_t i = 0; i < walk.size(); ++i) edges.push_back({walk[i], walk[(i + 1) % walk.size()]});
  }
  std::sort(edges.begin(), edges.end());
  Loops loops = outline.of(edges);
  std::sort(loops.begin(), loops.end());
  return loops;
}

TEST(OutlineLoops, StartAtTheirLeastPoint) {
  OutlineLoops outline(20);
  EXPECT_EQ(loops_of({{7, 3, 9, 4}, {12, 11, 10}}, outline), (Loops{{3, 9, 4, 7}, {10, 12, 11}}));
}

TEST(OutlineLoops, WalksThatTouchThemselvesFallApart) {
  OutlineLoops outline(20);
  EXPECT_EQ(loops_of({{0, 5, 1, 2, 5, 3}}, outline), (Loops{{0, 5, 3}, {1, 2, 5}}));
  EXPECT_EQ(loops_of({{4, 1, 6, 4, 2, 8, 4, 3, 9}}, outline), (Loops{{1, 6, 4}, {2, 8, 4}, {3, 9, 4}}));
}

TEST(OutlineLoops, NothingStaysFromTheFaceBefore) {
  OutlineLoops outline(20);
  const Loops square{{0, 1, 2, 3}};
  EXPECT_EQ(loops_of(square, outline), square);
  EXPECT_EQ(loops_of({{2, 5, 6}}, outline), (Loops{{2, 5, 6}}));
  EXPECT_EQ(loops_of({}, outline), Loops{});
  EXPECT_EQ(loops_of(square, outline), square);
}

}  // namespace
}  // namespace rad::repair
