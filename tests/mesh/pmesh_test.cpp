// Pmesh on single faces: what the patches must hold, whatever the outline.
#include "mesh/pmesh.h"

#include "tests/mesh/sound_patches.h"

namespace rad::tests {
namespace {

ConformingBuilder single_face(const Ring3& outer, const std::vector<Ring3>& holes = {},
                              const std::vector<std::array<LatticePoint, 2>>& inner = {}, const Ring3& single = {}) {
  ConformingBuilder builder;
  builder.add_face(outer, holes, inner, single);
  return builder;
}

std::size_t quads_in(const mesh::PatchMesh& mesh) {
  std::size_t quads = 0;
  for (const auto face : mesh.patches.faces()) quads += face.valence() == 4 ? 1 : 0;
  return quads;
}

TEST(Pmesh, MakesSquaresOfASquare) {
  const auto mesh = expect_sound(single_face(rectangle(0, 0, 4, 4)), 0.5);
  EXPECT_EQ(mesh.patches.n_faces(), 64U);
  EXPECT_EQ(quads_in(mesh), 64U);
  EXPECT_EQ(mesh.patches.n_vertices(), 81U);
}

TEST(Pmesh, LeavesASmallFaceWhole) {
  EXPECT_EQ(expect_sound(single_face(rectangle(0, 0, 0.4, 0.3)), 0.5).patches.n_faces(), 1U);
  EXPECT_EQ(expect_sound(single_face({at(0, 0), at(0.3, 0), at(0, 0.3)}), 0.5).patches.n_faces(), 1U);
}

TEST(Pmesh, MeshesRectanglesInAnyPlane) {
  for (const double length : {0.3, 0.47, 1.1}) {
    const auto mesh = expect_sound(single_face(tilted(rectangle(0, 0, 5, 3))), length);
    EXPECT_EQ(quads_in(mesh), mesh.patches.n_faces()) << length;
    expect_sound(single_face(reversed(rectangle(0, 0, 5, 3))), length);
  }
}

TEST(Pmesh, MeshesConcaveFaces) {
  const Ring3 ell{at(0, 0), at(5, 0), at(5, 1.3), at(1.7, 1.3), at(1.7, 4), at(0, 4)};
  Ring3 comb;
  for (int tooth = 0; tooth < 12; ++tooth) {
    comb.insert(comb.end(), {at(tooth, 0.1 * tooth), at(tooth + 0.5, 0.1 * tooth), at(tooth + 0.5, 5)});
    comb.push_back(at(tooth + 1, 5));
  }
  comb.insert(comb.end(), {at(12, 7), at(0, 7)});
  for (const Ring3& ring : {ell, comb}) {
    expect_sound(single_face(ring), 0.4);
    expect_sound(single_face(tilted(ring)), 0.4);
    expect_sound(single_face(ring), 3);
  }
}

TEST(Pmesh, MeshesAroundHoles) {
  std::vector<Ring3> holes;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j)
      holes.push_back(reversed(circle(1 + i, 1 + 1.1 * j, 0.1 + 0.03 * ((i + j) % 8), 7 + i)));
  }
  expect_sound(single_face(rectangle(0, 0, 9, 10), holes), 0.5);
  expect_sound(single_face(rectangle(0, 0, 9, 10), holes), 2);
}

TEST(Pmesh, MeshesHolesThatTouch) {
  const Ring3 outer = rectangle(0, 0, 4, 4);
  const Ring3 a = reversed({at(1, 1), at(2, 1), at(2, 2), at(1, 2)});
  const Ring3 b = reversed({at(2, 2), at(3, 2), at(3, 3), at(2, 3)});
  const Ring3 at_outline = reversed({at(0, 0), at(0.9, 0.3), at(0.3, 0.9)});
  expect_sound(single_face(outer, {a, b, at_outline}), 0.37, true);
}

TEST(Pmesh, MeshesACircleOfManyEdges) {
  const auto mesh = expect_sound(single_face(circle(0, 0, 60, 5000)), 4);
  EXPECT_GE(mesh.patches.n_faces(), 5000U / 2);
  expect_sound(single_face(tilted(circle(0, 0, 60, 1000))), 4);
}

TEST(Pmesh, MeshesNeedlesAndSpikes) {
  expect_sound(single_face({at(0, 0), at(20, 0), at(20, 0.2)}), 0.5, true);
  expect_sound(single_face({at(0, 0), at(10, 0.05), at(20, 0)}), 0.5, true);
  expect_sound(single_face(rectangle(0, 0, 30, 0.05)), 0.5);
  Ring3 star;
  for (int i = 0; i < 24; ++i) {
    const double angle = std::numbers::pi * i / 12, radius = i % 2 == 0 ? 12 : 0.8;
    star.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  expect_sound(single_face(star), 0.7, true);
  expect_sound(single_face(tilted(star)), 0.7, true);
}

TEST(Pmesh, KeepsSinglePointsAndInnerEdges) {
  const auto builder =
      single_face(rectangle(0, 0, 4, 4), {}, {{{at(1, 1), at(3, 1.2)}}, {{at(0, 2), at(1.1, 2.7)}}}, {at(2.03, 3.11)});
  const auto mesh = expect_sound(builder, 0.5);
  std::set<LatticePoint> used;
  for (const auto& [a, b] : edges_of(mesh)) used.insert({mesh.points[a], mesh.points[b]});
  for (const LatticePoint& p : {at(2.03, 3.11), at(1, 1), at(3, 1.2), at(0, 2), at(1.1, 2.7)}) {
    EXPECT_TRUE(used.contains(p));
  }
}

TEST(Pmesh, MeshesRingsWithinRings) {
  const auto ring = [](double r) { return circle(0, 0, r, 40); };
  ConformingBuilder builder;
  builder.add_face(ring(10), {reversed(ring(8))});
  builder.add_face(ring(8), {reversed(ring(5))});
  builder.add_face(ring(5), {reversed(ring(4.9))});
  builder.add_face(ring(4.9));
  const auto mesh = expect_sound(builder, 0.8);
  EXPECT_GT(mesh.patches.n_faces(), 500U);
}

Ring3 random_star(LatticeRandom& random) {
  Ring3 ring;
  const auto corners = random.between(3, 40);
  for (std::int64_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + 0.6 * random.unit()) / static_cast<double>(corners);
    const double radius = 2 + 8 * random.unit();
    ring.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return ring;
}

// What the repair promises: no point within T of an edge that does not use it, nor of another point.
bool keeps_tolerance(const Ring3& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
    for (std::size_t j = 0; j < ring.size(); ++j) {
      if (j == i || j == (i + 1) % ring.size()) continue;
      if (geom::point_within_segment(ring[j], a, b, kBuilderTolerance + 2)) return false;
    }
    if (geom::points_within(a, b, kBuilderTolerance + 6)) return false;
  }
  return true;
}

TEST(Pmesh, MeshesRandomPolygons) {
  LatticeRandom random(7);
  int meshed = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Ring3 ring = random_star(random);
    const Ring3 placed = trial % 2 == 0 ? ring : tilted(ring);
    const mesh::FaceFrame frame(single_face(placed).model(), single_face(placed).model().faces[0]);
    if (!keeps_tolerance(placed) || !frame.has_area()) continue;
    SCOPED_TRACE(trial);
    expect_sound(single_face(placed), 0.3 + 2 * random.unit(), true);
    ++meshed;
  }
  EXPECT_GT(meshed, 100);
}

TEST(Pmesh, ReachesTheEndsOfTheLattice) {
  constexpr std::int32_t kEnd = geom::kLatticeLimit - 1;
  ConformingBuilder builder;
  builder.add_box({-kEnd, -kEnd, -kEnd}, {kEnd, kEnd, kEnd});
  builder.add_face(
      {{-kEnd, -kEnd + 999, -kEnd + 5000}, {kEnd - 70000, -kEnd + 5000, kEnd - 999}, {kEnd - 5000, kEnd - 9, 0}});
  const auto mesh = expect_sound(builder, 2000);
  EXPECT_GT(mesh.patches.n_faces(), 6U * 81U);
}

TEST(Pmesh, GivesEmittersSmallerPatches) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 4));
  builder.use_material(1);
  builder.add_face(rectangle(0, 0, 4, 4, 3));
  std::vector<scene::Material> materials(2);
  materials[1].emission = {1, 1, 1};
  mesh::PatchOptions options;
  options.longest_edge = 1;
  options.materials = materials;
  const auto outcome = mesh::pmesh(builder.model(), options);
  ASSERT_TRUE(outcome.mesh);
  EXPECT_EQ(outcome.mesh->patches.n_faces(), 16U + 64U);
}

TEST(Pmesh, RefusesWhatWouldBeTooMuch) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 1000, 1000));
  mesh::PatchOptions options;
  options.longest_edge = 0.2;
  const auto outcome = mesh::pmesh(builder.model(), options);
  EXPECT_FALSE(outcome.mesh);
  EXPECT_NE(outcome.problem.find("longer patches"), std::string::npos) << outcome.problem;
}

TEST(Pmesh, ChoosesALengthForARoom) {
  ConformingBuilder builder;
  builder.add_box(at(0, 0, 0), at(5, 4, 3), true);
  const auto mesh = meshed(builder, 0);
  EXPECT_GT(mesh.patches.n_faces(), 500U);
  EXPECT_LT(mesh.patches.n_faces(), 1000U);
  EXPECT_EQ(mesh::default_patch_length({}), 4) << "4 T, and T is one pitch";
}

}  // namespace
}  // namespace rad::tests
