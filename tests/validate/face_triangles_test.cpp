// Which faces become triangles, and that these cover them exactly.
#include "validate/face_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "tests/support/derived_scene.h"
#include "tests/support/random_scenes.h"

namespace rad::validate {

// Found by the test framework.
void PrintTo(FaceCondition condition, std::ostream* out) {
  constexpr std::array kNames{"Sound", "LeftOut", "Degenerate", "RingCrosses"};
  *out << kNames[static_cast<std::size_t>(condition)];
}

namespace {

using geom::dvec3;
using tests::DerivedScene;
using tests::SceneSketch;
using Places = std::vector<dvec3>;

constexpr double kT = tests::kSceneTolerance;

// The face next to a large one, so that the lattice is the same for all.
DerivedScene derived(const Places& outer, const std::vector<Places>& holes = {}) {
  SceneSketch sketch;
  sketch.face(outer);
  for (const Places& hole : holes) sketch.hole(hole);
  sketch.face({{-64, -64, -64}, {64, -64, -64}, {64, 64, -64}});
  return {sketch.take(), kT};
}

FaceCondition condition_of(const Places& outer, const std::vector<Places>& holes = {}) {
  return derived(outer, holes).triangles.condition[0];
}

RingFlaw flaw_of(const Places& outer, const std::vector<Places>& holes = {}) {
  return derived(outer, holes).triangles.flaw[0];
}

TEST(FaceTriangles, ATriangleIsSoundWhereEveryHeightExceedsT) {
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {4, kT * 1.25, 0}}), FaceCondition::Sound);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {4, kT, 0}}), FaceCondition::Degenerate) << "equality is within";
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {4, 0, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {8, 0, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({{0, 0, 0}, {kT / 2, 0, 0}, {0, kT / 2, 0}}), FaceCondition::Degenerate) << "tiny";
}

TEST(FaceTriangles, APolygonIsDegenerateWhereTwiceItsAreaIsAtMostTTimesItsExtent) {
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {8, kT, 0}, {0, kT, 0}}), FaceCondition::Sound);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {8, kT / 4, 0}, {0, kT / 4, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {0, 0, 0}, {8, 0, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), FaceCondition::Degenerate);
}

TEST(FaceTriangles, LoopsOfFewCornersAreDegenerate) {
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({{0, 0, 0}}), FaceCondition::Degenerate);
  EXPECT_EQ(condition_of({}), FaceCondition::Degenerate);
}

TEST(FaceTriangles, AFaceWithACornerThatIsNotFiniteIsLeftOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, kNan}, {8, 8, 0}}), FaceCondition::LeftOut);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, kNan, 0}}), FaceCondition::LeftOut);
}

TEST(FaceTriangles, RingsThatCrossHaveNoTriangles) {
  const DerivedScene bow_tie = derived({{0, 0, 0}, {8, 8, 0}, {8, 0, 0}, {0, 8, 0}});
  EXPECT_EQ(bow_tie.triangles.condition[0], FaceCondition::RingCrosses);
  EXPECT_EQ(bow_tie.triangles.triangles.size(), 1U) << "that of the other face";
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{{6, 2, 0}, {12, 2, 0}, {12, 4, 0}}}),
            FaceCondition::RingCrosses);
}

TEST(FaceTriangles, LesserFlawsAreNamedAndTheFaceStillTriangulated) {
  const Places square{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  EXPECT_EQ(flaw_of(square), RingFlaw::None);
  EXPECT_EQ(flaw_of({{0, 0, 0}, {8, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}), RingFlaw::RepeatedPoint);
  EXPECT_EQ(flaw_of({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {0, 0, 0}}), RingFlaw::RepeatedPoint);
  EXPECT_EQ(flaw_of({{0, 0, 0}, {8, 0, 0}, {12, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}), RingFlaw::Spike);
  EXPECT_EQ(flaw_of(square, {{{10, 2, 0}, {12, 2, 0}, {12, 4, 0}}}), RingFlaw::HoleOutside);
  EXPECT_EQ(condition_of({{0, 0, 0}, {8, 0, 0}, {12, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}), FaceCondition::Sound);
}

TEST(FaceTriangles, NormalIsNewells) {
  const DerivedScene scene =
      derived({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{{2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}}});
  const double pitches = 1 / scene.model.lattice.pitch;
  EXPECT_EQ(scene.triangles.normal[0], dvec3(0, 0, 2 * (64 - 4) * pitches * pitches));
  EXPECT_EQ(newell_normal(scene.scene, scene.model, scene.scene.faces[0]), scene.triangles.normal[0]);
}

// Sum of the normals of a face's triangles, exact.
std::map<FaceId, std::array<geom::Int128, 3>> summed_normals(const FaceTriangles& triangles) {
  std::map<FaceId, std::array<geom::Int128, 3>> sums;
  for (std::size_t i = 0; i < triangles.triangles.size(); ++i) {
    const geom::IntVector& n = triangles.geometry[i].plane.normal;
    auto& sum = sums[triangles.triangles[i].face];
    sum = {sum[0] + n.x, sum[1] + n.y, sum[2] + n.z};
  }
  return sums;
}

TEST(FaceTriangles, CoverEverySoundFaceAndLookItsWay) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const DerivedScene scene(seed % 2 == 0 ? tests::coarse_scene(seed) : tests::fine_scene(seed), kT);
    const auto sums = summed_normals(scene.triangles);
    for (FaceId face = 0; face < scene.scene.faces.size(); ++face) {
      ASSERT_EQ(sums.contains(face), scene.triangles.condition[face] == FaceCondition::Sound);
      if (!sums.contains(face)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(static_cast<double>(sums.at(face)[axis]), scene.triangles.normal[face][static_cast<int>(axis)])
            << "seed " << seed << " face " << face;
      }
    }
  }
}

TEST(FaceTriangles, FlagTheOutlineAndNothingElse) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const DerivedScene scene(tests::coarse_scene(seed), kT);
    std::map<FaceId, int> outline;
    for (std::size_t i = 0; i < scene.triangles.triangles.size(); ++i) {
      for (const bool edge : scene.triangles.geometry[i].boundary) {
        outline[scene.triangles.triangles[i].face] += edge ? 1 : 0;
      }
    }
    for (const auto& [face, edges] : outline) {
      int corners = 0;
      for (const scene::Loop& loop : scene.scene.loops_of(scene.scene.faces[face]))
        corners += static_cast<int>(loop.count);
      ASSERT_EQ(edges, corners) << "seed " << seed << " face " << face;
    }
  }
}

// Where the corners that all triangles of the first face have in common are.
Places common_corners(const Places& outer) {
  const DerivedScene scene = derived(outer);
  std::vector<scene::PointId> common;
  bool first = true;
  for (const FaceTriangle& t : scene.triangles.triangles) {
    if (t.face != 0) continue;
    if (first) common.assign(t.points.begin(), t.points.end());
    first = false;
    std::erase_if(common, [&](scene::PointId id) { return std::ranges::find(t.points, id) == t.points.end(); });
  }
  Places places;
  for (const scene::PointId id : common) places.push_back(scene.model.lattice.position(scene.model.points[id]));
  return places;
}

// What draws polygons takes fans: with other triangles of a warped face something would be seen that repair is not of.
TEST(FaceTriangles, AWarpedPolygonIsAFanWhereOneCoversIt) {
  // From the corners at x = 4 a fan covers it; the lower one is first in space.
  const Places strip{{0, 0, 0}, {4, -1, 1}, {8, 0, 0}, {8, 3, 1}, {4, 1, 2}, {0, 3, 0}};
  EXPECT_EQ(common_corners(strip), Places({{4, -1, 1}}));
  Places turned = strip;
  std::ranges::reverse(turned);
  std::ranges::rotate(turned, turned.begin() + 2);
  EXPECT_EQ(common_corners(turned), Places({{4, -1, 1}}));
}

TEST(FaceTriangles, AWarpedPolygonThatNoFanCoversIsTriangulatedAllTheSame) {
  const Places two_notches{{0, 0, 0}, {3, 2, 1}, {6, 0, 0}, {6, 6, 1}, {3, 4, 0}, {0, 6, 1}};
  EXPECT_EQ(condition_of(two_notches), FaceCondition::Sound);
}

TEST(FaceTriangles, StartAtTheirSmallestPointAndComeByFace) {
  const DerivedScene scene(tests::coarse_scene(3), kT);
  FaceId last = 0;
  for (std::size_t i = 0; i < scene.triangles.triangles.size(); ++i) {
    const FaceTriangle& t = scene.triangles.triangles[i];
    EXPECT_LT(t.points[0], std::min(t.points[1], t.points[2]));
    EXPECT_GE(t.face, last);
    last = t.face;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(scene.triangles.geometry[i].points[k], scene.model.points[t.points[k]]);
    }
  }
}

}  // namespace
}  // namespace rad::validate
