// A third of the faces of random scenes of solids is turned over: repair turns every one of them back.
#include <gtest/gtest.h>

#include <algorithm>

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

// Blocks on a slab, beside and on each other on a grid so coarse that they often touch; some hold a smaller solid.
Scene solid_scene(std::uint64_t seed, bool own_objects) {
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
  int number = 0;
  const auto add = [&](const Block& block) {
    ++number;
    sketch.use(own_objects ? "block " + std::to_string(number) : "", number % 2 == 0 ? "stone" : "wood");
    sketch.box(block.low, block.high);
  };
  for (const Block& block : blocks) {
    add(block);
    if (random.one_in(3)) add({block.low + dvec3(0.25), block.high - dvec3(0.25)});
  }
  return sketch.take();
}

std::vector<FaceId> a_third(const Scene& scene, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::vector<FaceId> some;
  for (FaceId face = 0; face < scene.faces.size(); ++face) {
    if (random.unit() < 0.3) some.push_back(face);
  }
  return some;
}

std::size_t expect_restored(std::uint64_t seed, bool own_objects) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Scene sound = solid_scene(seed, own_objects);
  const std::vector<FaceId> some = a_third(sound, seed);
  const Scene flipped = turned(sound, some);
  const Repaired expected = tests::repaired(sound, kTolerance), result = tests::repaired(flipped, kTolerance);
  EXPECT_EQ(result.unresolved, 0U);
  EXPECT_TRUE(tests::placed_triangles(result.model, flipped) == tests::placed_triangles(expected.model, sound));
  return some.size();
}

TEST(OrientationProperty, FacesOfSolidsAreTurnedBack) {
  std::size_t flips = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) flips += expect_restored(seed, true);
  EXPECT_GT(flips, 1000U);
}

// The same before anything is repaired, face by face: what is restored is the input.
TEST(OrientationProperty, FacesAreTurnedBackOneByOne) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene sound = solid_scene(seed, true);
    const std::vector<FaceId> some = a_third(sound, seed);
    Scene scene = turned(sound, some);
    EXPECT_EQ(orient(scene, {}, geom::ToleranceRequest{kTolerance, geom::ToleranceRequest::Measure::FileUnits}), some);
  }
}

}  // namespace
}  // namespace rad::repair
