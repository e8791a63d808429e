// Faces that were turned at random are turned back.
#include "repair/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/derived_scene.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_variants.h"
#include "validate/orientation_sets.h"

namespace rad::repair {
namespace {

using scene::dvec3;
using scene::FaceId;
using scene::Scene;

constexpr geom::ToleranceRequest kRequest{1.0 / 256, geom::ToleranceRequest::Measure::FileUnits};

dvec3 normal_of(const Scene& scene, FaceId face) {
  const auto corners = scene.corners_of(scene.loops[scene.faces[face].first_loop]);
  dvec3 sum(0, 0, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(scene.vertices[corners[i]], scene.vertices[corners[(i + 1) % corners.size()]]);
  }
  return sum;
}

void expect_same_facings(const Scene& scene, const Scene& expected) {
  for (FaceId face = 0; face < expected.faces.size(); ++face) {
    EXPECT_GT(glm::dot(normal_of(scene, face), normal_of(expected, face)), 0) << "face " << face;
  }
}

// A prism over a star of random radii, outward.
void add_prism(tests::SceneSketch& sketch, tests::LatticeRandom& random, const dvec3& centre) {
  const std::int64_t sides = random.between(3, 12);
  const double height = 1 + random.unit();
  std::vector<dvec3> low, high;
  for (std::int64_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    const double radius = 1 + random.unit();
    low.push_back(centre + dvec3(radius * std::cos(angle), radius * std::sin(angle), 0));
    high.push_back(low.back() + dvec3(0, 0, height));
  }
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    sketch.face({low[i], low[next], high[next], high[i]});
  }
  sketch.face(high);
  std::reverse(low.begin(), low.end());
  sketch.face(low);
}

Scene random_solids(std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  tests::SceneSketch sketch;
  for (std::int64_t i = random.between(1, 3); i > 0; --i) {
    const dvec3 place(10.0 * static_cast<double>(i), 0, 0);
    if (random.one_in(3)) {
      sketch.box(place, place + dvec3(1 + random.unit(), 1 + random.unit(), 1 + random.unit()));
    } else {
      add_prism(sketch, random, place);
    }
  }
  return sketch.take();
}

std::vector<FaceId> some_faces(const Scene& scene, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  std::vector<FaceId> some;
  for (FaceId face = 0; face < scene.faces.size(); ++face) {
    if (random.unit() < 0.3) some.push_back(face);
  }
  return some;
}

std::vector<FaceId> oriented(Scene& scene) { return orient(scene, {}, kRequest).turned; }

TEST(Orientation, TurnsBackWhatWasTurned) {
  std::size_t faces = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const Scene sound = random_solids(seed);
    const std::vector<FaceId> some = some_faces(sound, seed);
    Scene scene = turned(sound, some);
    EXPECT_EQ(oriented(scene), some);
    expect_same_facings(scene, sound);
    EXPECT_TRUE(oriented(scene).empty());
    faces += some.size();
  }
  EXPECT_GT(faces, 200u);
}

TEST(Orientation, TurnsTwiceToTheSame) {
  const Scene sound = random_solids(7);
  const std::vector<FaceId> some = some_faces(sound, 7);
  const Scene once = turned(sound, some), twice = turned(once, some);
  EXPECT_NE(once.corners, sound.corners);
  EXPECT_EQ(twice.corners, sound.corners);
  EXPECT_LT(glm::dot(normal_of(once, some[0]), normal_of(sound, some[0])), 0);
}

TEST(Orientation, TurnsHolesWithTheirFace) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
  sketch.hole({{2, 2, 0}, {2, 4, 0}, {4, 4, 0}});
  const Scene scene = sketch.take();
  EXPECT_EQ(turned(scene, {0}).corners, (std::vector<scene::VertexId>{0, 3, 2, 1, 4, 6, 5}));
}

TEST(Orientation, TurnsASolidThatIsInsideOut) {
  const Scene sound = random_solids(3);
  std::vector<FaceId> all;
  for (FaceId face = 0; face < sound.faces.size(); ++face) all.push_back(face);
  Scene scene = turned(sound, all);
  EXPECT_EQ(oriented(scene), all);
}

Scene room(bool furnished) {
  tests::SceneSketch sketch;
  sketch.use("room", "wall");
  sketch.box({0, 0, 0}, {8, 6, 3});
  if (furnished) {
    sketch.use("box", "wood");
    sketch.box({2, 2, 1}, {3, 3, 2});
  }
  return turned(sketch.take(), {0, 1, 2, 3, 4, 5});
}

TEST(Orientation, LeavesAFurnishedRoomAlone) {
  Scene furnished = room(true);
  EXPECT_TRUE(oriented(furnished).empty());
  Scene empty = room(false);
  EXPECT_EQ(oriented(empty).size(), 6u);
}

TEST(Orientation, MendsARoomWithTwoWallsTurned) {
  const Scene sound = room(true);
  Scene scene = turned(sound, {1, 4});
  EXPECT_EQ(oriented(scene), (std::vector<FaceId>{1, 4}));
}

Scene moebius_strip(int pieces, double half_turns) {
  tests::SceneSketch sketch;
  const auto at = [&](int i, double across) {
    const double around = 2 * std::numbers::pi * i / pieces, twist = half_turns * around / 2;
    const double radius = 4 + across * std::cos(twist);
    return dvec3(radius * std::cos(around), radius * std::sin(around), across * std::sin(twist));
  };
  for (int i = 0; i < pieces; ++i) {
    const bool last = i + 1 == pieces;
    const double flip = last && std::fmod(half_turns, 2) != 0 ? -1 : 1;
    const int next = (i + 1) % pieces;
    sketch.face({at(i, -1), at(next, -flip), at(i, 1)});
    sketch.face({at(next, -flip), at(next, flip), at(i, 1)});
  }
  return sketch.take();
}

TEST(Orientation, LeavesAMoebiusStripAlone) {
  Scene strip = moebius_strip(40, 1);
  EXPECT_TRUE(oriented(strip).empty());
  const std::vector<FaceId> some = some_faces(strip, 5);
  Scene disturbed = turned(strip, some);
  EXPECT_TRUE(oriented(disturbed).empty());
}

// At the edge at which a strip with half a turn closes something of another object hangs: by its objects alone two
// faces of the strip are neighbours there. What is certain has to agree all the same, and does without the objects too.
TEST(Orientation, MendsWhatIsOneSidedByAGuessOnly) {
  Scene strip = moebius_strip(40, 1);
  strip.objects.assign({"strip", "flag"});
  for (scene::Face& face : strip.faces) face.object = 0;
  const std::vector<scene::VertexId> seam(strip.corners.begin(), strip.corners.begin() + 3);
  const auto tip = static_cast<scene::VertexId>(strip.vertices.size());
  strip.vertices.push_back({9, 0, 4});
  scene::Face flag = strip.faces[0];
  flag.object = 1;
  flag.first_loop = static_cast<std::uint32_t>(strip.loops.size());
  strip.loops.push_back({static_cast<std::uint32_t>(strip.corners.size()), 3});
  strip.corners.insert(strip.corners.end(), {seam[0], seam[2], tip});
  strip.faces.push_back(flag);
  Scene scene = turned(strip, {7, 8, 30});
  EXPECT_EQ(oriented(scene), (std::vector<FaceId>{7, 8, 30}));
  for (scene::Face& face : scene.faces) face.object = 0;
  EXPECT_TRUE(oriented(scene).empty());
}

TEST(Orientation, MendsAStripWithAFullTurn) {
  const Scene sound = moebius_strip(40, 2);
  Scene scene = turned(sound, {3, 4, 30});
  EXPECT_EQ(oriented(scene), (std::vector<FaceId>{3, 4, 30}));
}

TEST(Orientation, LeavesARugThatIsFlushWithItsFloor) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  sketch.face({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  sketch.face({{9, 0, 0}, {12, 0, 0}, {12, 4, 0}, {9, 4, 0}});
  sketch.face({{9, 0, 0}, {12, 0, 0}, {12, 4, 0}, {9, 4, 0}});
  Scene scene = sketch.take();
  EXPECT_TRUE(oriented(scene).empty());
}

// Two roofs over each other from one eave on, at a small angle: lint finds no fault that turning could cure.
TEST(Orientation, LeavesTwoSheetsThatLeaveAnEdgeOnOneSide) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {0, 4, 0}, {-4, 4, 0.1}, {-4, 0, 0.1}});
  sketch.face({{0, 0, 0}, {0, 4, 0}, {-4, 4, 0.2}, {-4, 0, 0.2}});
  Scene scene = sketch.take();
  EXPECT_TRUE(oriented(scene).empty());
  std::string refusal;
  const auto context = validate::build_context(scene, {}, kRequest, refusal);
  EXPECT_TRUE(validate::disagreements_of(*context).empty());
}

// Of two halves that disagree the larger one stays, whatever the order of faces.
TEST(Orientation, TurnsTheSmallerPart) {
  tests::SceneSketch sketch;
  sketch.face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  sketch.face({{1, 0, 0}, {1, 1, 0}, {4, 1, 0}, {4, 0, 0}});
  Scene scene = sketch.take();
  EXPECT_EQ(oriented(scene), std::vector<FaceId>{0});
}

// Two equal halves: the one that stays is told by its place.
TEST(Orientation, DoesNotDependOnTheOrderOfFaces) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    tests::SceneSketch sketch;
    for (int i = 0; i < 8; ++i) {
      const double x0 = 0.7 * i, x1 = 0.7 * (i + 1), z0 = 0.1 * i * i, z1 = 0.1 * (i + 1) * (i + 1);
      if (i < 4) {
        sketch.face({{x0, 0, z0}, {x1, 0, z1}, {x1, 1, z1}, {x0, 1, z0}});
      } else {
        sketch.face({{x0, 0, z0}, {x0, 1, z0}, {x1, 1, z1}, {x1, 0, z1}});
      }
    }
    const Scene drawn = sketch.take();
    Scene first = drawn, second = tests::rewritten(drawn, seed);
    const auto lines_turned = [](Scene& scene) {
      std::vector<std::uint64_t> lines;
      for (const FaceId face : oriented(scene)) lines.push_back(scene.faces[face].source.record);
      std::sort(lines.begin(), lines.end());
      return lines;
    };
    EXPECT_EQ(lines_turned(second), lines_turned(first));
  }
}

}  // namespace
}  // namespace rad::repair
