// The lattice model of a scene is the same however the scene is written down.
#include "scene/lattice_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scene/scene_builder.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_variants.h"

namespace rad::scene {
namespace {

using Ids = std::vector<VertexId>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void add_triangle(SceneBuilder& builder, const dvec3& a, const dvec3& b, const dvec3& c) {
  const Ids ids{builder.add_vertex(a), builder.add_vertex(b), builder.add_vertex(c)};
  builder.add_face(ids, builder.scene().faces.size() + 1);
}

// Triangles with corners on a coarse grid, so that many positions repeat.
Scene random_scene(tests::LatticeRandom& random, int faces) {
  SceneBuilder builder("", "obj");
  builder.add_section({"", "", RecordKind::Line});
  const auto point = [&] {
    const geom::LatticePoint p = random.grid_point(3, 1);
    return dvec3(0.3 * p.x, 0.3 * p.y, 0.3 * p.z);
  };
  for (int i = 0; i < faces; ++i) {
    const dvec3 a = point(), b = point();
    add_triangle(builder, a, b, point());
  }
  return builder.take();
}

// Faces as sequences of lattice points from the least on, in ascending order.
std::vector<std::vector<LatticePoint>> faces_of(const Scene& scene, const LatticeModel& model) {
  std::vector<std::vector<LatticePoint>> faces;
  for (const Face& face : scene.faces) {
    std::vector<LatticePoint> corners;
    for (const PointId id : model.corners_of(scene.loops[face.first_loop])) corners.push_back(model.points[id]);
    std::vector<LatticePoint> least = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      least = std::min(least, corners);
    }
    faces.push_back(least);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(LatticeModel, PointsAscendAndMapEveryVertexToItsPlace) {
  tests::LatticeRandom random(1);
  const Scene scene = random_scene(random, 200);
  const LatticeModel model = build_lattice_model(scene);
  EXPECT_TRUE(std::is_sorted(model.points.begin(), model.points.end()));
  EXPECT_EQ(std::adjacent_find(model.points.begin(), model.points.end()), model.points.end());
  EXPECT_LE(model.points.size(), 343U) << "equal positions are one point";
  ASSERT_EQ(model.corners.size(), scene.corners.size());
  for (std::size_t i = 0; i < scene.corners.size(); ++i) {
    ASSERT_EQ(model.corners[i], model.point_of_vertex[scene.corners[i]]);
    const dvec3 off = model.position(model.corners[i]) - scene.vertices[scene.corners[i]];
    ASSERT_LE(std::hypot(off.x, off.y, off.z), model.lattice.pitch * std::numbers::sqrt3 / 2);
  }
}

TEST(LatticeModel, DoesNotDependOnTheOrderOfTheFile) {
  tests::LatticeRandom random(2);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(random, 50);
    const Scene shuffled = tests::rewritten(scene, seed);
    const LatticeModel model = build_lattice_model(scene), other = build_lattice_model(shuffled);
    ASSERT_EQ(other.points, model.points);
    ASSERT_EQ(other.lattice.pitch, model.lattice.pitch);
    ASSERT_EQ(other.lattice.origin, model.lattice.origin);
    ASSERT_EQ(faces_of(shuffled, other), faces_of(scene, model));
    ASSERT_EQ(tolerance_basis(shuffled, other).median_object_diagonal,
              tolerance_basis(scene, model).median_object_diagonal);
  }
}

TEST(LatticeModel, LeavesOutFacesWithCornersThatAreNotFinite) {
  SceneBuilder builder("", "obj");
  add_triangle(builder, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_triangle(builder, {0, 0, 5}, {1, 0, kNan}, {0, 1, 5});
  add_triangle(builder, {0, 0, 5}, {kInfinity, 0, 5}, {0, 1, 5});
  add_triangle(builder, {0, 0, 5}, {1, -kInfinity, 5}, {0, 1, 5});
  const Scene scene = builder.take();
  const LatticeModel model = build_lattice_model(scene);
  EXPECT_EQ(model.left_out, (std::vector<bool>{false, true, true, true}));
  EXPECT_EQ(model.point_of_vertex[4], kNoPoint);
  EXPECT_EQ(model.corners[4], kNoPoint);
  EXPECT_EQ(model.box.high, (dvec3{1, 1, 5})) << "finite corners of faces left out belong to the box";
  EXPECT_EQ(model.points.size(), 5U);
}

TEST(LatticeModel, LeavesOutAFaceForACornerOfItsHole) {
  SceneBuilder builder("", "obj");
  for (int i = 0; i < 6; ++i) builder.add_vertex({i % 3 == 0 ? 0.0 : 1.0, i, i == 5 ? kNan : 0});
  builder.add_face(Ids{0, 1, 2}, 1);
  builder.add_hole(Ids{3, 4, 5});
  EXPECT_EQ(build_lattice_model(builder.take()).left_out, (std::vector<bool>{true}));
}

TEST(LatticeModel, IgnoresVerticesThatNoFaceUses) {
  SceneBuilder builder("", "obj");
  const VertexId stray = builder.add_vertex({1e30, 0, 0});
  add_triangle(builder, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const LatticeModel model = build_lattice_model(builder.take());
  EXPECT_EQ(model.point_of_vertex[stray], kNoPoint);
  EXPECT_EQ(model.box.high, (dvec3{1, 1, 0}));
}

TEST(LatticeModel, IsEmptyWithoutAFiniteVertex) {
  SceneBuilder builder("", "obj");
  add_triangle(builder, {kNan, 0, 0}, {kNan, 0, 0}, {kNan, 0, 0});
  const Scene scene = builder.take();
  const LatticeModel model = build_lattice_model(scene);
  EXPECT_TRUE(model.points.empty());
  EXPECT_TRUE(model.box.empty());
  EXPECT_EQ(model.left_out, (std::vector<bool>{true}));
  EXPECT_EQ(tolerance_basis(scene, model).diagonal, 0);
  EXPECT_TRUE(build_lattice_model(empty_scene("", "obj")).points.empty());
}

TEST(ToleranceBasis, TakesTheMedianDiagonalOfConnectedObjects) {
  SceneBuilder builder("", "ply");
  const auto add_object = [&](double at, double size) {
    add_triangle(builder, {at, 0, 0}, {at + 3 * size, 4 * size, 0}, {at, 4 * size, 0});
    add_triangle(builder, {at, 0, 0}, {at + 3 * size, 4 * size, 0}, {at + 3 * size, 0, 0});
  };
  add_object(0, 1);
  add_object(100, 2);
  add_object(200, 16);
  Scene scene = builder.take();
  scene.single_precision = true;
  const geom::ToleranceBasis basis = tolerance_basis(scene, build_lattice_model(scene));
  EXPECT_NEAR(basis.median_object_diagonal, 10, 1e-4);
  EXPECT_DOUBLE_EQ(basis.diagonal, std::hypot(248, 64));
  EXPECT_EQ(basis.largest_magnitude, 248);
  EXPECT_TRUE(basis.single_precision);
}

TEST(ToleranceBasis, CountsAHoleWithItsFaceAndNoFaceLeftOut) {
  SceneBuilder builder("", "obj");
  for (const double x : {0.0, 8.0, 2.0}) {
    builder.add_vertex({x, 0, 0});
    builder.add_vertex({x + 4, 0, 0});
    builder.add_vertex({x, 3, 0});
  }
  builder.add_face(Ids{0, 1, 2}, 1);
  builder.add_hole(Ids{6, 7, 8});
  const VertexId bad = builder.add_vertex({kNan, 0, 0});
  builder.add_face(Ids{3, 4, bad}, 2);
  builder.add_face(Ids{}, 3);
  const Scene scene = builder.take();
  const geom::ToleranceBasis basis = tolerance_basis(scene, build_lattice_model(scene));
  EXPECT_NEAR(basis.median_object_diagonal, std::hypot(6, 3), 1e-4) << "one object: face and hole";
}

TEST(RecordedLattice, IsUsedAgainWithItsTolerance) {
  tests::LatticeRandom random(3);
  Scene scene = random_scene(random, 20);
  const LatticeModel first = build_lattice_model(scene);
  // Coarser by 2^4 and moved: as after a repair that took faces away from the edge of the box.
  const geom::Lattice recorded{first.lattice.pitch * 16, {0.5, -0.25, 0.125}};
  scene.recorded = RecordedLattice{recorded, recorded.pitch * 100};
  const LatticeModel model = build_lattice_model(scene);
  EXPECT_EQ(model.lattice.pitch, recorded.pitch);
  EXPECT_EQ(model.lattice.origin, recorded.origin);
  const geom::Tolerance t = geom::default_tolerance(tolerance_basis(scene, model));
  EXPECT_EQ(t.source, geom::ToleranceSource::Recorded);
  EXPECT_EQ(t.pitches, 100);
}

TEST(RecordedLattice, IsPassedOverAsAWholeWhereAPartIsOfNoUse) {
  tests::LatticeRandom random(4);
  Scene scene = random_scene(random, 20);
  const LatticeModel plain = build_lattice_model(scene);
  const double h = plain.lattice.pitch, d = plain.box.diagonal();
  const std::vector<RecordedLattice> useless = {
      {{h, plain.lattice.origin}, 7 * h},
      {{h, plain.lattice.origin}, 0.011 * d},
      {{h * 1.5, {0, 0, 0}}, 100 * h},
      {{-h, {0, 0, 0}}, 100 * h},
      {{kNan, {0, 0, 0}}, 100 * h},
      {{h, {kInfinity, 0, 0}}, 100 * h},
      {{h, {1e9, 0, 0}}, 100 * h},
      {{h / 16, {0, 0, 0}}, 100 * h},
      {{h, plain.lattice.origin}, kNan},
      {{h * 0x1p20, {0, 0, 0}}, h * 0x1p24},
      {{0, {0, 0, 0}}, 0},
  };
  for (const RecordedLattice& record : useless) {
    scene.recorded = record;
    const LatticeModel model = build_lattice_model(scene);
    EXPECT_EQ(model.lattice.pitch, h);
    EXPECT_EQ(model.points, plain.points);
    EXPECT_NE(geom::default_tolerance(tolerance_basis(scene, model)).source, geom::ToleranceSource::Recorded);
  }
}

TEST(RecordedLattice, IsPassedOverInAnEmptyScene) {
  Scene scene = empty_scene("", "obj");
  scene.recorded = RecordedLattice{{0.25, {0, 0, 0}}, 4};
  EXPECT_EQ(build_lattice_model(scene).lattice.pitch, geom::Lattice{}.pitch);
}

}  // namespace
}  // namespace rad::scene
