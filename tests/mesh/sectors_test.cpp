// Vertices of the patch mesh are sectors: shared within surfaces, parted wherever radiosity may jump.
#include "tests/mesh/sound_patches.h"

namespace rad::tests {
namespace {

std::size_t vertices_at(const mesh::PatchMesh& mesh, const LatticePoint& point) {
  std::size_t count = 0;
  for (const auto vertex : mesh.patches.vertices()) {
    if (mesh.points[mesh.patches.data(vertex).lattice_point] == point) ++count;
  }
  return count;
}

void expect_manifold(const mesh::PatchMesh& mesh) {
  for (const auto vertex : mesh.patches.vertices()) {
    EXPECT_TRUE(mesh.patches.is_manifold(vertex));
    EXPECT_GT(vertex.valence(), 1U) << "no vertex without patches";
  }
}

TEST(Sectors, PartTheSidesOfACube) {
  ConformingBuilder builder;
  builder.add_box(at(0, 0, 0), at(1, 1, 1));
  const auto mesh = expect_sound(builder, 0.5);
  expect_manifold(mesh);
  EXPECT_EQ(mesh.patches.n_faces(), 24U);
  EXPECT_EQ(mesh.patches.n_vertices(), 6U * 9U);
  EXPECT_EQ(vertices_at(mesh, at(0, 0, 0)), 3U);
  EXPECT_EQ(vertices_at(mesh, at(0.5, 0, 0)), 2U);
  EXPECT_EQ(vertices_at(mesh, at(0.5, 0.5, 0)), 1U);
}

ConformingBuilder prism(int sides) {
  ConformingBuilder builder;
  const Ring3 ring = circle(0, 0, 2, sides);
  const auto raised = [](LatticePoint p) { return LatticePoint{p.x, p.y, 3 * kUnit}; };
  for (int i = 0; i < sides; ++i) {
    const auto a = ring[static_cast<std::size_t>(i)], b = ring[static_cast<std::size_t>((i + 1) % sides)];
    builder.add_face({a, b, raised(b), raised(a)});
  }
  return builder;
}

TEST(Sectors, JoinSmoothSides) {
  const auto round = expect_sound(prism(24), 0.4);
  expect_manifold(round);
  std::set<std::uint32_t> used;
  for (const auto& [a, b] : edges_of(round)) used.insert({a, b});
  EXPECT_EQ(round.patches.n_vertices(), used.size()) << "15 degrees an edge: one surface";
  const auto angular = expect_sound(prism(6), 0.4);
  expect_manifold(angular);
  EXPECT_EQ(vertices_at(angular, at(2, 0, 0)), 2U);
}

TEST(Sectors, PartMaterialsAndObjects) {
  for (int differing = 0; differing < 3; ++differing) {
    ConformingBuilder builder;
    builder.add_face(rectangle(0, 0, 1, 1));
    builder.use_material(differing == 1 ? 1 : 0);
    builder.use_object(differing == 2 ? 1 : 0);
    builder.add_face(rectangle(1, 0, 2, 1));
    EXPECT_EQ(vertices_at(meshed(builder, 0.5), at(1, 0.5)), differing == 0 ? 1U : 2U);
  }
}

// A wall without thickness stands on a floor; the whole foot is one edge inside the floor.
ConformingBuilder wall_on_floor() {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 4), {}, {{{at(1, 2), at(3, 2)}}});
  builder.add_face({at(1, 2), at(3, 2), at(3, 2, 1), at(1, 2, 1)});
  return builder;
}

TEST(Sectors, PartTheFloorOnBothSidesOfAWall) {
  for (const double length : {0.5, 1.0, 4.0}) {
    const auto mesh = expect_sound(wall_on_floor(), length);
    expect_manifold(mesh);
    EXPECT_EQ(vertices_at(mesh, at(2, 2)), 3U) << "two of the floor, one of the wall, at length " << length;
    EXPECT_EQ(vertices_at(mesh, at(1, 2)), 2U) << "the floor runs around the end of the wall";
    EXPECT_EQ(vertices_at(mesh, at(4, 4)), 1U);
  }
}

TEST(Sectors, PartFlatSidesUnderAWallOnTheirCommonEdge) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 2));
  builder.add_face(rectangle(0, 2, 4, 4));
  builder.add_face({at(0, 2), at(4, 2), at(4, 2, 1), at(0, 2, 1)});
  const auto mesh = expect_sound(builder, 1);
  expect_manifold(mesh);
  EXPECT_EQ(vertices_at(mesh, at(2, 2)), 3U);
  EXPECT_EQ(vertices_at(mesh, at(0, 2)), 3U);
}

TEST(Sectors, OfABoxOnTheGround) {
  ConformingBuilder builder;
  const auto base = rectangle(1, 1, 2, 2);
  builder.add_face(rectangle(0, 0, 4, 4), {reversed(base)});
  for (std::size_t i = 0; i < 4; ++i) {
    const auto raised = [](LatticePoint p) { return LatticePoint{p.x, p.y, kUnit}; };
    const auto a = base[i], b = base[(i + 1) % 4];
    builder.add_face({a, b, raised(b), raised(a)});
  }
  builder.add_face(rectangle(1, 1, 2, 2, 1));
  const auto mesh = expect_sound(builder, 0.4);
  expect_manifold(mesh);
  EXPECT_EQ(vertices_at(mesh, at(1, 1)), 3U);
}

// Slits too short to be divided cannot part their sides; the patches are all there nevertheless.
TEST(Sectors, LoseNoPatchAtShortSlits) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 1, 1), {}, {{{at(0.5, 0.5), at(0.56, 0.5)}}});
  builder.add_face({at(0.5, 0.5), at(0.56, 0.5), at(0.53, 0.5, 0.5)});
  const auto mesh = meshed(builder, 0.5);
  expect_exact_cover(builder.model(), mesh);
  EXPECT_EQ(mesh.patches.data(*std::prev(mesh.patches.faces_end())).face, 1U);
}

}  // namespace
}  // namespace rad::tests
