#include "solve/visibility.h"

#include <gtest/gtest.h>

#include "solve/receivers.h"
#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

std::uint8_t blocked(const Visibility& visibility, const dvec3& from, const dvec3& to) {
  const Segment segment{from, to};
  std::uint8_t result = 2;
  visibility.trace({&segment, 1}, {&result, 1});
  return result;
}

TEST(Visibility, APlateBlocksFromBothSides) {
  tests::GridMesh grid(3);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 3, 1, 0);
  const Visibility visibility(grid.mesh);
  EXPECT_EQ(blocked(visibility, {0.4, 0.45, 1}, {0.5, 0.55, -1}), 1);
  EXPECT_EQ(blocked(visibility, {0.4, 0.45, -1}, {0.5, 0.55, 1}), 1);
  EXPECT_EQ(blocked(visibility, {1.1, 0.5, 1}, {1.1, 0.5, -1}), 0);
  EXPECT_EQ(blocked(visibility, {0.4, 0.45, 1}, {0.4, 0.45, 0.01}), 0);
}

TEST(Visibility, SegmentsBetweenLiftedPointsOfTwoSurfacesAreFree) {
  for (const double offset : {0.0, 5000.0}) {
    tests::GridMesh grid(3);
    const dvec3 low = dvec3(offset), high = low + dvec3(1);
    grid.add_box(low, high, true, 4, 1, 0);
    const Visibility visibility(grid.mesh);
    const double lift = lift_of(grid.mesh);
    int count = 0;
    for (const mesh::Patch& from : grid.mesh.patches) {
      for (const mesh::Patch& to : grid.mesh.patches) {
        if (from.normal == to.normal) continue;
        // A point near a corner of each patch, so that many ends lie next to a third face.
        const auto near_corner = [&](const mesh::Patch& patch) {
          const auto& node = patch.corners.node;
          const auto at = [&](int i) { return grid.mesh.nodes[node[i]].position; };
          return at(0) + (at(2) - at(0)) * 0.01 + patch.normal * lift;
        };
        EXPECT_EQ(blocked(visibility, near_corner(from), near_corner(to)), 0);
        ++count;
      }
    }
    EXPECT_EQ(count, 96 * 80);
  }
}

TEST(Visibility, WithoutPatchesNothingIsBlocked) {
  const mesh::RadiosityMesh nothing;
  const Visibility visibility(nothing);
  EXPECT_EQ(blocked(visibility, {0, 0, 0}, {1, 1, 1}), 0);
}

TEST(Visibility, ManySegmentsGiveWhatEachGivesAlone) {
  tests::GridMesh grid(3);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 3, 1, 0);
  const Visibility visibility(grid.mesh);
  std::vector<Segment> segments;
  for (int i = 0; i < 37; ++i) segments.push_back({{-0.51 + 0.06 * i, 0.4, 1}, {-0.51 + 0.06 * i, 0.5, -1}});
  std::vector<std::uint8_t> together(segments.size());
  visibility.trace(segments, together);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_EQ(together[i], blocked(visibility, segments[i].from, segments[i].to)) << i;
    const double x = segments[i].from.x;
    EXPECT_EQ(together[i], x > 0 && x < 1) << x;
  }
}

}  // namespace
}  // namespace rad::solve
