// Every way in which an element can be anchored.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "geom/predicates.h"
#include "mesh/element_anchors.h"

namespace rad::mesh {
namespace {

// Nodes 0 to 3 are corners, 4 to 7 middles; a square and a triangle of even coordinates.
constexpr std::array<geom::PlanarPoint, 4> kSquare{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}};
constexpr std::array<geom::PlanarPoint, 3> kTriangle{{{0, 0}, {8, 0}, {2, 8}}};

geom::PlanarPoint place(std::uint32_t count, NodeId node) {
  const std::span<const geom::PlanarPoint> corners =
      count == 4 ? std::span<const geom::PlanarPoint>(kSquare) : std::span<const geom::PlanarPoint>(kTriangle);
  if (node < 4) return corners[node];
  const auto &a = corners[node - 4], &b = corners[(node - 3) % count];
  return {(a.u + b.u) / 2, (a.v + b.v) / 2};
}

std::int64_t cross(const geom::PlanarPoint& a, const geom::PlanarPoint& b) { return a.u * b.v - a.v * b.u; }

void expect_conforming(std::uint32_t count, unsigned mask) {
  Corners corners{{0, 1, 2, 3}, count};
  std::array<NodeId, 4> middle{kNoNode, kNoNode, kNoNode, kNoNode};
  std::set<std::pair<NodeId, NodeId>> outline;
  for (NodeId i = 0; i < count; ++i) {
    const NodeId next = (i + 1) % count;
    if ((mask >> i & 1U) != 0) {
      middle[i] = 4 + i;
      outline.insert({i, 4 + i});
      outline.insert({4 + i, next});
    } else {
      outline.insert({i, next});
    }
  }
  const AnchoredPieces pieces = anchored_pieces(corners, middle);
  std::set<std::pair<NodeId, NodeId>> edges;
  std::int64_t area = 0;
  for (const Corners& piece : pieces.all()) {
    for (std::uint32_t i = 0; i < piece.count; ++i) {
      const NodeId a = piece.node[i], b = piece.node[(i + 1) % piece.count], c = piece.node[(i + 2) % piece.count];
      EXPECT_EQ(geom::orient2d(place(count, a), place(count, b), place(count, c)), geom::Sign::Positive);
      EXPECT_TRUE(edges.insert({a, b}).second) << "an edge used twice in one direction";
      area += cross(place(count, a), place(count, b));
    }
  }
  EXPECT_EQ(area, count == 4 ? 128 : 64);
  std::set<std::pair<NodeId, NodeId>> single;
  for (const auto& edge : edges) {
    if (!edges.contains({edge.second, edge.first})) single.insert(edge);
  }
  EXPECT_EQ(single, outline);
}

TEST(Anchors, CoverTheElementForEveryMask) {
  for (const std::uint32_t count : {3U, 4U}) {
    for (unsigned mask = 0; mask < 1U << count; ++mask) {
      SCOPED_TRACE(testing::Message() << count << " corners, mask " << mask);
      expect_conforming(count, mask);
    }
  }
}

TEST(Anchors, HaveTheSixTypesOfThePaper) {
  const auto sizes = [](std::uint32_t count, std::array<NodeId, 4> middle) {
    std::multiset<std::uint32_t> result;
    const AnchoredPieces pieces = anchored_pieces({{0, 1, 2, 3}, count}, middle);
    for (const Corners& piece : pieces.all()) result.insert(piece.count);
    return result;
  };
  constexpr NodeId k = kNoNode;
  using Sizes = std::multiset<std::uint32_t>;
  EXPECT_EQ(sizes(3, {4, k, k, k}), (Sizes{3, 3}));
  EXPECT_EQ(sizes(3, {4, 5, k, k}), (Sizes{3, 3, 3}));
  EXPECT_EQ(sizes(4, {4, k, k, k}), (Sizes{3, 3, 3}));
  EXPECT_EQ(sizes(4, {4, 5, k, k}), (Sizes{3, 3, 3, 3}));
  EXPECT_EQ(sizes(4, {4, k, 6, k}), (Sizes{4, 4}));
  EXPECT_EQ(sizes(4, {4, 5, 6, k}), (Sizes{3, 3, 3, 4}));
}

}  // namespace
}  // namespace rad::mesh
