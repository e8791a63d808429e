// A third of the faces of random scenes of solids is turned over: repair turns every one of them back.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "repair/orientation.h"
#include "tests/support/derived_scene.h"
#include "tests/support/lattice_random.h"
#include "tests/support/repaired_checks.h"

namespace rad::repair {
namespace {

using scene::dvec3;
using scene::FaceId;
using scene::Scene;

constexpr double kTolerance = 1.0 / 64;
constexpr geom::ToleranceRequest kRequest{kTolerance, geom::ToleranceRequest::Measure::FileUnits};
constexpr std::uint64_t kScenes = 100;

struct Block {
  dvec3 low{0, 0, 0};
  dvec3 high{0, 0, 0};
};

bool overlap(const Block& a, const Block& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.high[axis] <= b.low[axis] || b.high[axis] <= a.low[axis]) return false;
  }
  return true;
}

/// Six faces for each block, in order.
struct SolidScene {
  Scene scene;
  std::vector<bool> nested;  ///< per block: it holds another or lies in one
};

// Blocks on a slab, beside and on each other on a grid so coarse that they often touch; some hold a smaller solid.
SolidScene solid_scene(std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::vector<Block> blocks{{{-1, -1, -1}, {9, 9, 0}}};
  for (int tries = 0; tries < 12; ++tries) {
    const auto at = [&](std::int64_t reach) { return static_cast<double>(random.between(0, reach)); };
    const double x = at(6), y = at(6);
    const dvec3 low(x, y, at(2));
    const double a = 1 + at(2), b = 1 + at(2);
    const Block block{low, low + dvec3(a, b, 1 + at(2))};
    if (std::ranges::none_of(blocks, [&](const Block& other) { return overlap(other, block); }))
      blocks.push_back(block);
  }
  tests::SceneSketch sketch;
  SolidScene result;
  const auto add = [&](const Block& block, bool nested) {
    sketch.use("block " + std::to_string(result.nested.size()), result.nested.size() % 2 == 0 ? "stone" : "wood");
    sketch.box(block.low, block.high);
    result.nested.push_back(nested);
  };
  for (const Block& block : blocks) {
    const bool holds_another = random.one_in(3);
    add(block, holds_another);
    if (holds_another) add({block.low + dvec3(0.25), block.high - dvec3(0.25)}, true);
  }
  result.scene = sketch.take();
  return result;
}

double area_of(const Scene& scene, FaceId face) {
  const auto corners = scene.corners_of(scene.loops[scene.faces[face].first_loop]);
  const dvec3 &a = scene.vertices[corners[0]], &b = scene.vertices[corners[1]], &c = scene.vertices[corners[2]];
  return glm::length(glm::cross(b - a, c - b));
}

// Three faces of ten. A block that looks inward for its larger part and holds another is a room, and one that lies in
// another is a hole in it: of these, nobody can tell, and only smaller parts are turned.
std::vector<FaceId> a_third(const SolidScene& solids, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::vector<FaceId> some;
  for (FaceId block = 0; block < solids.nested.size(); ++block) {
    std::vector<FaceId> own;
    double area = 0, whole = 0;
    for (FaceId face = 6 * block; face < 6 * block + 6; ++face) {
      whole += area_of(solids.scene, face);
      if (random.unit() >= 0.3) continue;
      own.push_back(face);
      area += area_of(solids.scene, face);
    }
    if (!solids.nested[block] || 2 * area < whole) some.insert(some.end(), own.begin(), own.end());
  }
  return some;
}

// What goes into the planes is then the same, and so is all that comes out.
TEST(OrientationProperty, FacesOfSolidsAreTurnedBack) {
  std::size_t flips = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolidScene solids = solid_scene(seed);
    const std::vector<FaceId> some = a_third(solids, seed);
    const Scene flipped = turned(solids.scene, some);
    Scene scene = flipped;
    EXPECT_EQ(orient(scene, {}, kRequest).turned, some);
    EXPECT_EQ(scene.corners, solids.scene.corners);
    const Repaired result = tests::repaired(flipped, kTolerance), expected = tests::repaired(solids.scene, kTolerance);
    EXPECT_EQ(result.unresolved, 0U);
    EXPECT_TRUE(tests::placed_triangles(result.model, flipped) ==
                tests::placed_triangles(expected.model, solids.scene));
    flips += some.size();
  }
  EXPECT_GT(flips, 1000U);
}

}  // namespace
}  // namespace rad::repair
