// Triangles come back to the polygons that they were cut from.
#include "repair/maximal_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "tests/support/conforming_builder.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

using tests::at;
using tests::ConformingBuilder;
using tests::rectangle;
using tests::reversed;
using tests::Ring3;

// Loops of a face as rings of places that start at their first in space; ascending.
std::vector<Ring3> rings_of(const scene::ConformingModel& model, const scene::ConformingFace& face) {
  std::vector<Ring3> rings;
  for (const scene::Loop& loop : model.loops_of(face)) {
    Ring3 ring;
    for (const PointId id : model.corners_of(loop)) ring.push_back(model.points[id]);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    rings.push_back(ring);
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

std::vector<std::vector<Ring3>> all_rings(const scene::ConformingModel& model) {
  std::vector<std::vector<Ring3>> all;
  for (const auto& face : model.faces) all.push_back(rings_of(model, face));
  std::sort(all.begin(), all.end());
  return all;
}

// The scene that the faces of a drawn model came from: only their names count.
scene::Scene source_of(const scene::ConformingModel& model) {
  scene::Scene scene = scene::empty_scene("scene.obj", "obj");
  for (const auto& face : model.faces) {
    scene.materials.resize(std::max<std::size_t>(scene.materials.size(), face.material + 1));
    scene.objects.resize(std::max<std::size_t>(scene.objects.size(), face.object + 1));
    scene.faces.push_back({0, 0, face.material, face.object, face.group, {}});
  }
  return scene;
}

// All triangles of a drawn model in any order. Faces are in the planes given.
PlanarTriangles triangles_of(const scene::ConformingModel& model, const std::vector<Plane>& planes,
                             const std::vector<ClusterId>& plane_of_face, std::uint32_t seed) {
  PlanarTriangles set{model.points, planes, {}};
  for (scene::FaceId id = 0; id < model.faces.size(); ++id) {
    const Plane& plane = planes[plane_of_face[id]];
    for (const auto& points : model.triangles_of(model.faces[id])) {
      const auto corner = [&](std::size_t k) { return geom::as_vector(model.points[points[k]]); };
      const bool along = glm::dot(glm::cross(corner(1) - corner(0), corner(2) - corner(0)), plane.normal) > 0;
      set.members.push_back({points, plane_of_face[id], along, id});
    }
  }
  std::mt19937 random(seed);
  const auto members = set.members;
  set.members.clear();
  for (const std::uint32_t i : tests::shuffled(members.size(), random)) set.members.push_back(members[i]);
  return set;
}

scene::ConformingModel put_together(const ConformingBuilder& drawn, const std::vector<Plane>& planes,
                                    const std::vector<ClusterId>& plane_of_face, std::uint32_t seed) {
  const auto& model = drawn.model();
  return maximal_faces(triangles_of(model, planes, plane_of_face, seed), source_of(model), model.lattice,
                       model.tolerance);
}

scene::ConformingModel put_together_flat(const ConformingBuilder& drawn, std::uint32_t seed = 1) {
  return put_together(drawn, {Plane({0, 0, 1}, {})}, std::vector<ClusterId>(drawn.model().faces.size(), 0), seed);
}

void expect_comes_back(const ConformingBuilder& drawn) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(all_rings(put_together_flat(drawn, seed)), all_rings(drawn.model()));
  }
}

TEST(MaximalFaces, PutsAPolygonWithHolesTogether) {
  ConformingBuilder drawn;
  drawn.add_face(tests::circle(0, 0, 10, 23), {reversed(tests::circle(-3, 0, 2, 7)), reversed(rectangle(2, -2, 5, 3)),
                                               reversed(tests::circle(0, 6, 1, 5))});
  expect_comes_back(drawn);
}

TEST(MaximalFaces, PutsATiltedPolygonTogether) {
  ConformingBuilder drawn;
  drawn.add_face(tests::tilted(tests::circle(0, 0, 9, 17)), {reversed(tests::tilted(rectangle(-2, -2, 3, 3)))});
  const auto model = put_together(drawn, {Plane({1, -2, 2}, {})}, {0}, 3);
  EXPECT_EQ(all_rings(model), all_rings(drawn.model()));
}

TEST(MaximalFaces, PutsFacesThatLookDownTogether) {
  ConformingBuilder drawn;
  drawn.add_face(reversed(rectangle(0, 0, 8, 8)), {rectangle(2, 2, 4, 5)});
  expect_comes_back(drawn);
  const auto model = put_together_flat(drawn);
  ASSERT_EQ(model.loops.size(), 2u);
  EXPECT_EQ(model.loops[0].count, 4u);
  EXPECT_EQ(model.points[model.corners[0]], at(0, 0)) << "the outer loop comes first";
}

TEST(MaximalFaces, KeepsACheckerboardOfMaterials) {
  ConformingBuilder drawn;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      drawn.use_material(static_cast<scene::MaterialId>((i + j) % 2));
      drawn.add_face(rectangle(i, j, i + 1, j + 1));
    }
  }
  expect_comes_back(drawn);
}

TEST(MaximalFaces, MergesTilesOfOneMaterial) {
  ConformingBuilder drawn;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) drawn.add_face(rectangle(i, j, i + 1, j + 1));
  }
  const auto model = put_together_flat(drawn);
  ASSERT_EQ(model.faces.size(), 1u);
  EXPECT_EQ(model.faces[0].loop_count, 1u);
  EXPECT_EQ(model.faces[0].triangle_count, 72u);
  EXPECT_EQ(model.faces[0].inner_edge_count, 0u);
  EXPECT_EQ(model.loops[0].count, 24u) << "points on the outline stay";
}

TEST(MaximalFaces, KeepsObjectsGroupsAndFacingsApart) {
  ConformingBuilder drawn;
  drawn.add_face(rectangle(0, 0, 1, 1));
  drawn.use_object(1);
  drawn.add_face(rectangle(1, 0, 2, 1));
  drawn.add_face(reversed(rectangle(2, 0, 3, 1)));
  expect_comes_back(drawn);
}

TEST(MaximalFaces, KeepsFiveAnnuliInEachOther) {
  for (const bool one_material : {false, true}) {
    ConformingBuilder drawn;
    for (int i = 0; i < 5; ++i) {
      const double outer = 2 * (5 - i) + 1, inner = outer - (one_material ? 1 : 2);
      if (!one_material) drawn.use_material(static_cast<scene::MaterialId>(i % 2));
      drawn.add_face(tests::circle(0, 0, outer, 24), {reversed(tests::circle(0, 0, inner, 24))});
    }
    expect_comes_back(drawn);
  }
}

// A hole that touches the outline in a point, and two holes that touch each other.
TEST(MaximalFaces, KeepsLoopsThatTouchSimple) {
  ConformingBuilder drawn;
  drawn.add_face({at(0, 0), at(10, 0), at(10, 5), at(10, 10), at(0, 10)},
                 {{at(10, 5), at(8, 4), at(8, 6)}, {at(2, 2), at(4, 4), at(5, 2)}, {at(4, 4), at(2, 6), at(5, 6)}});
  const auto model = put_together_flat(drawn);
  ASSERT_EQ(model.faces.size(), 1u);
  for (const scene::Loop& loop : model.loops) {
    std::vector<PointId> ids(model.corners_of(loop).begin(), model.corners_of(loop).end());
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  }
  std::map<std::pair<LatticePoint, LatticePoint>, int> expected, found;
  const auto count = [](const scene::ConformingModel& of, auto& edges) {
    for (const scene::Loop& loop : of.loops) {
      const auto ids = of.corners_of(loop);
      for (std::size_t i = 0; i < ids.size(); ++i) ++edges[{of.points[ids[i]], of.points[ids[(i + 1) % ids.size()]]}];
    }
  };
  count(drawn.model(), expected);
  count(model, found);
  EXPECT_EQ(found, expected);
}

// A wall on a floor: the floor stays one face, with an edge inside it.
TEST(MaximalFaces, KeepsASlitWhereAWallStands) {
  ConformingBuilder drawn;
  drawn.add_face(rectangle(0, 0, 4, 4), {}, {{{at(1, 2), at(3, 2)}}});
  drawn.add_face({at(1, 2), at(3, 2), at(3, 2, 1), at(1, 2, 1)});
  const auto model = put_together(drawn, {Plane({0, 0, 1}, {}), Plane({0, -1, 0}, at(1, 2))}, {0, 1}, 2);
  ASSERT_EQ(model.faces.size(), 2u);
  ASSERT_EQ(model.inner_edges.size(), 1u);
  const scene::ConformingFace& floor = model.faces[0].inner_edge_count == 1 ? model.faces[0] : model.faces[1];
  EXPECT_EQ(floor.source, 0u);
  EXPECT_EQ(model.points[model.inner_edges[0][0]], at(1, 2));
  EXPECT_EQ(model.points[model.inner_edges[0][1]], at(3, 2));
}

// Three faces at one edge of one plane: nothing runs through.
TEST(MaximalFaces, SeparatesWhereAWallStandsAcross) {
  ConformingBuilder drawn;
  drawn.add_face(rectangle(0, 0, 2, 4));
  drawn.add_face(rectangle(2, 0, 4, 4));
  drawn.add_face({at(2, 0), at(2, 4), at(2, 4, 1), at(2, 0, 1)});
  const auto model = put_together(drawn, {Plane({0, 0, 1}, {}), Plane({1, 0, 0}, at(2, 0))}, {0, 0, 1}, 2);
  EXPECT_EQ(model.faces.size(), 3u);
}

TEST(MaximalFaces, NumbersPointsInTheOrderOfSpace) {
  ConformingBuilder drawn;
  drawn.add_face(tests::circle(0, 0, 10, 50));
  const auto first = put_together_flat(drawn, 1), second = put_together_flat(drawn, 2);
  EXPECT_TRUE(std::is_sorted(first.points.begin(), first.points.end()));
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.corners, second.corners);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(MaximalFaces, NamesTheSourceThatMostCameFrom) {
  ConformingBuilder drawn;
  drawn.add_face(rectangle(0, 0, 1, 1));
  drawn.add_face(tests::circle(30, 30, 4, 30));
  drawn.add_face({at(1, 0), at(3, 0), at(3, 1), at(2, 1.5), at(1, 1)});
  const auto model = put_together_flat(drawn);
  ASSERT_EQ(model.faces.size(), 2u);
  std::vector<scene::FaceId> sources{model.faces[0].source, model.faces[1].source};
  std::sort(sources.begin(), sources.end());
  EXPECT_EQ(sources, (std::vector<scene::FaceId>{1, 2}));
}

}  // namespace
}  // namespace rad::repair
