// The element library against the paper's pseudo code, and what every element mesh must hold.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "geom/planar_shape.h"
#include "mesh/element_views.h"
#include "mesh/emesh.h"
#include "tests/mesh/naive_elements.h"
#include "tests/mesh/sound_patches.h"

namespace rad::tests {
namespace {

using mesh::ElementId;
using mesh::ElementMesh;

// An L of quadrilaterals and triangles, and a square on its edge at a right angle.
ConformingBuilder two_surfaces() {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(32, 0), at(32, 12), at(16, 20), at(16, 32), at(0, 32)});
  builder.add_face({at(32, 0), at(32, 0, 24), at(32, 12, 24), at(32, 12)});
  return builder;
}

Outline outline_of(const ElementMesh& elements, ElementId element) {
  Outline outline;
  for (const auto corners = elements.corners(element); const mesh::NodeId node : corners.all()) {
    outline.push_back(geom::as_vector(elements.points()[elements.point_of(node)]));
  }
  return outline;
}

std::vector<Outline> leaf_outlines(const ElementMesh& elements) {
  std::vector<Outline> outlines;
  for (const ElementId leaf : elements.leaves()) outlines.push_back(outline_of(elements, leaf));
  return outlines;
}

// Every leaf of one is a leaf of the other.
void expect_alike(const std::vector<Outline>& leaves, const std::vector<Outline>& others) {
  ASSERT_EQ(leaves.size(), others.size());
  for (const Outline& leaf : leaves) {
    ASSERT_TRUE(std::any_of(others.begin(), others.end(), [&](const Outline& other) { return alike(leaf, other); }));
  }
}

std::vector<ElementId> random_leaves(const ElementMesh& elements, LatticeRandom& random, std::int64_t one_in) {
  std::vector<ElementId> chosen;
  for (const ElementId leaf : elements.leaves()) {
    if (random.one_in(one_in)) chosen.push_back(leaf);
  }
  return chosen;
}

// Within each surface the edges of the anchored pieces have two uses, one in each direction, but for the border.
void expect_anchored_conforming(const ElementMesh& elements) {
  std::set<std::pair<mesh::NodeId, mesh::NodeId>> edges;
  std::set<std::pair<mesh::NodeId, mesh::NodeId>> border;
  for (const ElementId leaf : elements.leaves()) {
    const mesh::Corners corners = elements.corners(leaf);
    for (std::uint32_t edge = 0; edge < corners.count; ++edge) {
      const auto neighbours = elements.neighbours(leaf, edge);
      EXPECT_LE(neighbours.size(), 2U);
      for (const ElementId other : neighbours) {
        EXPECT_LE(std::max(elements.level(leaf), elements.level(other)) -
                      std::min(elements.level(leaf), elements.level(other)),
                  1U);
      }
      if (neighbours.empty()) border.insert({corners.node[edge], corners.node[(edge + 1) % corners.count]});
    }
    for (const auto pieces = elements.anchored(leaf); const mesh::Corners& piece : pieces.all()) {
      for (std::uint32_t i = 0; i < piece.count; ++i) {
        EXPECT_TRUE(edges.insert({piece.node[i], piece.node[(i + 1) % piece.count]}).second);
      }
    }
  }
  for (const auto& edge : edges) {
    if (!edges.contains({edge.second, edge.first})) {
      EXPECT_TRUE(border.contains(edge)) << "a T-vertex inside a surface";
    }
  }
}

TEST(Elements, FollowThePaper) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    LatticeRandom random(seed);
    ElementMesh elements(meshed(two_surfaces(), 8));
    NaiveElements naive;
    for (const ElementId leaf : elements.leaves()) {
      naive.add(outline_of(elements, leaf), static_cast<int>(elements.source(elements.patch_of(leaf)).face));
    }
    for (int round = 0; round < 5; ++round) {
      const auto chosen = random_leaves(elements, random, 12);
      std::vector<Outline> outlines;
      for (const ElementId leaf : chosen) outlines.push_back(outline_of(elements, leaf));
      elements.refine(chosen);
      naive.refine(outlines);
      std::vector<Outline> expected;
      for (const auto& leaf : naive.leaves()) expected.push_back(leaf.corners);
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
      expect_alike(leaf_outlines(elements), expected);
      expect_anchored_conforming(elements);
    }
  }
}

TEST(Elements, DoNotDependOnTheOrderOfRefinement) {
  LatticeRandom random(5);
  const mesh::PatchMesh patches = meshed(two_surfaces(), 8);
  for (int trial = 0; trial < 20; ++trial) {
    ElementMesh one(patches), other(patches), parted(patches);
    for (int round = 0; round < 4; ++round) {
      auto chosen = random_leaves(one, random, 6);
      one.refine(chosen);
      std::reverse(chosen.begin(), chosen.end());
      if (!chosen.empty()) chosen.push_back(chosen.front());
      const auto added = other.refine(chosen);
      EXPECT_EQ(added.last, other.node_count());
      ASSERT_EQ(one.leaves(), other.leaves());
      ASSERT_EQ(one.points(), other.points());
    }
    const auto a = random_leaves(parted, random, 3), b = random_leaves(parted, random, 3);
    ElementMesh turned = parted;
    parted.refine(a);
    parted.refine(b);
    turned.refine(b);
    turned.refine(a);
    expect_alike(leaf_outlines(parted), leaf_outlines(turned));
  }
}

TEST(Elements, StayLargeEnough) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(3, 0), at(3, 0.3)});
  builder.add_face({at(0, 0), at(3, 0.3), at(1, 3)});
  ElementMesh elements(meshed(builder, 1));
  for (int round = 0; round < 12; ++round) elements.refine(elements.leaves());
  EXPECT_EQ(elements.refine(elements.leaves()).first, elements.node_count()) << "nothing is left to divide";
  expect_anchored_conforming(elements);
  std::set<std::pair<Corner, Corner>> edges;
  for (const ElementId leaf : elements.leaves()) {
    for (const auto pieces = elements.anchored(leaf); const mesh::Corners& piece : pieces.all()) {
      for (std::uint32_t i = 0; i < piece.count; ++i) {
        edges.insert(
            std::minmax(elements.point_of(piece.node[i]), elements.point_of(piece.node[(i + 1) % piece.count])));
      }
    }
  }
  expect_no_t_vertices(elements.points(), edges, kBuilderTolerance);
}

TEST(Elements, OfEmeshAreShort) {
  ElementMesh elements(meshed(two_surfaces(), 8));
  mesh::emesh(elements, {.longest_edge = 1.5});
  for (const ElementId leaf : elements.leaves()) {
    const Outline outline = outline_of(elements, leaf);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_LE(glm::distance(outline[i], outline[(i + 1) % outline.size()]), 1.5 * kUnit + mesh::kLengthRounding);
    }
  }
  expect_anchored_conforming(elements);
}

double shape_of(const Outline& corners) {
  const geom::dvec3 x = glm::normalize(corners[1] - corners[0]);
  const geom::dvec3 n = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  std::vector<geom::PlanePoint> flat;
  for (const auto& p : corners) {
    flat.push_back({glm::dot(p - corners[0], x), glm::dot(p - corners[0], glm::cross(n, x))});
  }
  return geom::scaled_shape(flat);
}

// Four-to-one division of a triangle or a parallelogram makes similar children.
TEST(Elements, KeepTheShapeOfTheirPatch) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0), at(20, 2), at(9, 14)});
  builder.add_face({at(0, 0, 5), at(16, 2, 5), at(14, 16, 5), at(-2, 14, 5)});
  ElementMesh elements(meshed(builder, 40));
  std::vector<double> expected;
  for (const ElementId leaf : elements.leaves()) expected.push_back(shape_of(outline_of(elements, leaf)));
  mesh::emesh(elements, {.longest_edge = 0.7});
  for (const ElementId leaf : elements.leaves()) {
    ASSERT_NEAR(shape_of(outline_of(elements, leaf)), expected[elements.patch_of(leaf)], 0.01);
  }
}

// --- the views ---

std::vector<std::pair<Corner, Corner>> display_edges(const mesh::DisplayFace& face) {
  std::vector<std::pair<Corner, Corner>> edges;
  for (std::uint32_t i = 0; i < face.count; ++i) edges.emplace_back(face.corner[i], face.corner[(i + 1) % face.count]);
  return edges;
}

void expect_ziplocked(const mesh::DisplayMesh& display) {
  std::map<LatticePoint, Corner> place;
  std::vector<LatticePoint> points;
  const auto place_of = [&](Corner vertex) {
    const LatticePoint& point = display.vertices[vertex].point;
    const auto [entry, added] = place.try_emplace(point, static_cast<Corner>(points.size()));
    if (added) points.push_back(point);
    return entry->second;
  };
  std::set<std::pair<Corner, Corner>> edges;
  for (const auto& face : display.faces) {
    for (const auto& [a, b] : display_edges(face)) edges.insert(std::minmax(place_of(a), place_of(b)));
  }
  expect_no_t_vertices(points, edges, kBuilderTolerance);
}

TEST(Display, IsZiplockedAcrossSurfaces) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    LatticeRandom random(seed);
    ConformingBuilder builder;
    builder.add_box(at(0, 0, 0), at(5, 4, 3), true);
    builder.add_face({at(1, 2, 0.5), at(3, 2, 0.6), at(3, 3, 2), at(1, 3, 2.1)});
    ElementMesh elements(meshed(builder, 1.7));
    for (int round = 0; round < 3; ++round) elements.refine(random_leaves(elements, random, 9));
    const mesh::DisplayMesh display = mesh::display_mesh(elements);
    expect_ziplocked(display);
    EXPECT_GT(display.vertices.size(), elements.node_count()) << "some surface has nodes that its neighbour lacks";
    geom::dvec3 closed(0, 0, 0);
    double area = 0;
    for (const auto& face : display.faces) {
      const auto p = [&](std::uint32_t i) { return geom::as_vector(display.vertices[face.corner[i]].point); };
      for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
        const auto n = glm::cross(p(i) - p(0), p(i + 1) - p(0)) * 0.5;
        EXPECT_GT(glm::dot(n, elements.source(face.patch).normal), 0);
        area += glm::length(n) / (kUnit * static_cast<double>(kUnit));
        if (elements.source(face.patch).face < 6) closed += n;
      }
    }
    EXPECT_EQ(glm::length(closed), 0) << "the box stays closed, exactly";
    const double tilted = glm::length(glm::cross(geom::dvec3(2, 0, 0.1), geom::dvec3(0, 1, 1.5)));
    EXPECT_NEAR(area, 94 + tilted, 0.01);
  }
}

TEST(Display, InterpolatesWhereOnlyTheOtherSideHasANode) {
  ElementMesh elements(meshed(two_surfaces(), 8));
  std::vector<ElementId> wall;
  for (const ElementId leaf : elements.leaves()) {
    if (elements.source(elements.patch_of(leaf)).face == 1) wall.push_back(leaf);
  }
  elements.refine(wall);
  const mesh::DisplayMesh display = mesh::display_mesh(elements);
  std::size_t between = 0;
  for (const auto& vertex : display.vertices) {
    const auto end = [&](std::size_t i) {
      return geom::as_vector(elements.points()[elements.point_of(vertex.node[i])]);
    };
    EXPECT_LE(glm::distance(geom::as_vector(vertex.point), end(0) * (1 - vertex.share) + end(1) * vertex.share), 2);
    between += vertex.node[0] == vertex.node[1] ? 0U : 1U;
  }
  EXPECT_EQ(between, 2U) << "the common edge has two patch edges";
}

TEST(RadiosityView, KnowsSectorsOfASquareAndASlit) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 4, 4), {}, {{{at(2, 2), at(4, 2)}}});
  const ElementMesh elements(meshed(builder, 1));
  const mesh::RadiosityMesh view = mesh::radiosity_mesh(elements);
  std::size_t on_slit = 0;
  double area = 0;
  for (const auto& patch : view.patches) area += patch.area;
  EXPECT_DOUBLE_EQ(area, 16);
  for (const auto& node : view.nodes) {
    EXPECT_EQ(node.normal, geom::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(node.element_size, 1);
    const geom::dvec3 p = node.position;
    if (p == geom::dvec3(0, 0, 0)) {
      EXPECT_NEAR(glm::distance(node.inward, geom::dvec3(std::sqrt(0.5), std::sqrt(0.5), 0)), 0, 1e-12);
    } else if (p == geom::dvec3(1, 1, 0)) {
      EXPECT_EQ(node.inward, geom::dvec3(0, 0, 0));
    } else if (p == geom::dvec3(2, 2, 0)) {
      EXPECT_NEAR(glm::distance(node.inward, geom::dvec3(-1, 0, 0)), 0, 1e-12);
    } else if (p == geom::dvec3(3, 2, 0)) {
      EXPECT_NEAR(std::abs(node.inward.y), 1, 1e-12);
      ++on_slit;
    }
  }
  EXPECT_EQ(on_slit, 2U);
  EXPECT_EQ(mesh::leaves_of_elements(elements).size(), view.elements.size());
}

TEST(RadiosityView, StepsInwardBehindNoFace) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0, 0), at(2, 0, 0), at(2, 2, 0), at(0, 2, 0)});
  builder.add_face({at(2, 0, 0), at(4, -1, 1), at(4, 1, 1), at(2, 2, 0)});
  const mesh::RadiosityMesh view = mesh::radiosity_mesh(ElementMesh(meshed(builder, 3)));
  const geom::dvec3 rising = glm::normalize(geom::dvec3(-1, 0, 2));
  std::size_t ends = 0;
  for (const auto& node : view.nodes) {
    if (node.position.x != 2 || (node.position.y != 0 && node.position.y != 2)) continue;
    EXPECT_NEAR(glm::length(node.inward), 1, 1e-12);
    EXPECT_GE(node.inward.z, -1e-12);
    EXPECT_GE(glm::dot(node.inward, rising), -1e-12);
    ++ends;
  }
  EXPECT_EQ(ends, 2U);
}

TEST(RadiosityView, HasSmoothNormals) {
  ConformingBuilder builder;
  builder.add_face({at(0, 0, 0), at(2, 0, 0), at(2, 2, 0), at(0, 2, 0)});
  builder.add_face({at(2, 0, 0), at(4, 0, 1), at(4, 2, 1), at(2, 2, 0)});
  const mesh::RadiosityMesh view = mesh::radiosity_mesh(ElementMesh(meshed(builder, 3)));
  const double slope = std::sqrt(5.0);
  const geom::dvec3 expected = glm::normalize(geom::dvec3(0, 0, 1) * 4.0 + geom::dvec3(-1, 0, 2) / slope * (2 * slope));
  std::size_t found = 0;
  for (const auto& node : view.nodes) {
    if (node.position.x != 2) continue;
    EXPECT_NEAR(glm::distance(node.normal, expected), 0, 1e-12);
    ++found;
  }
  EXPECT_EQ(found, 2U);
}

TEST(Views, AreTheSameForAnyNumberOfThreads) {
  ConformingBuilder builder = two_surfaces();
  for (int i = 0; i < 20; ++i) builder.add_face(tilted(rectangle(40 + i, 0, 40.5 + i, 9)));
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    ElementMesh elements(meshed(builder, 1));
    mesh::emesh(elements, {.longest_edge = 0.6});
    const mesh::RadiosityMesh view = mesh::radiosity_mesh(elements);
    std::vector<double> numbers;
    for (const auto& node : view.nodes) {
      for (int axis = 0; axis < 3; ++axis) {
        numbers.insert(numbers.end(), {node.position[axis], node.normal[axis], node.inward[axis]});
      }
    }
    for (const auto& element : view.elements) {
      for (const auto node : element.corners.all()) numbers.push_back(node);
    }
    for (const auto& face : mesh::display_mesh(elements).faces) {
      numbers.insert(numbers.end(), face.corner.begin(), face.corner.end());
    }
    return numbers;
  };
  EXPECT_EQ(run(1), run(2));
}

}  // namespace
}  // namespace rad::tests
