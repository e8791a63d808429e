// Shadow lines against brute force: every element that a border of shadow crosses is marked.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include "mesh/crossed_leaves.h"
#include "mesh/emesh.h"
#include "mesh/hemicube.h"
#include "tests/mesh/sound_patches.h"

namespace rad::tests {
namespace {

using geom::dvec3;
using mesh::ElementId;
using mesh::ElementMesh;

std::vector<scene::Material> one_light() {
  std::vector<scene::Material> materials(2);
  materials[1].emission = {10, 10, 10};
  return materials;
}

ElementMesh elements_of(const ConformingBuilder& builder, double patch, double element) {
  ElementMesh elements(meshed(builder, patch));
  mesh::emesh(elements, {.longest_edge = element});
  return elements;
}

// A floor, a small light above it that looks down, and boxes between them that touch nothing.
ConformingBuilder boxes_in_light(std::uint64_t seed, int boxes) {
  LatticeRandom random(seed);
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 10, 10));
  for (int box = 0; box < boxes; ++box) {
    const double x = 1 + 6 * random.unit(), y = 1 + 6 * random.unit(), z = 0.6 + box;
    builder.add_box(at(x, y, z), at(x + 0.4 + 1.6 * random.unit(), y + 0.4 + 1.6 * random.unit(), z + 0.3));
  }
  builder.use_material(1);
  builder.add_face(reversed(rectangle(4.9, 4.8, 5.2, 5.1, 9)));
  return builder;
}

dvec3 place_in(const ElementMesh& elements, ElementId leaf, double u, double v) {
  const mesh::Corners corners = elements.corners(leaf);
  const auto at_corner = [&](std::uint32_t i) {
    return geom::as_vector(elements.points()[elements.point_of(corners.node[i])]);
  };
  if (corners.count == 3) {
    if (u + v > 1) std::tie(u, v) = std::pair(1 - u, 1 - v);
    return at_corner(0) * (1 - u - v) + at_corner(1) * u + at_corner(2) * v;
  }
  return (at_corner(0) * (1 - u) + at_corner(1) * u) * (1 - v) + (at_corner(3) * (1 - u) + at_corner(2) * u) * v;
}

// Some of 64 by 64 points see the light and some do not.
bool crossed(const ElementMesh& elements, const mesh::PatchRays& rays, const mesh::LightSample& light, ElementId leaf) {
  constexpr int kRays = 64;
  const dvec3 normal = elements.source(elements.patch_of(leaf)).normal;
  int seen = 0, hidden = 0;
  for (int i = 0; i < kRays; ++i) {
    for (int j = 0; j < kRays; ++j) {
      const dvec3 way = place_in(elements, leaf, (i + 0.5) / kRays, (j + 0.5) / kRays) - light.place;
      if (glm::dot(way, normal) >= 0 || glm::dot(way, light.normal) <= 0) return false;
      const auto hit = rays.nearest(light.place, glm::normalize(way));
      ++(hit && hit->distance < glm::length(way) - kBuilderTolerance ? hidden : seen);
    }
  }
  return seen > 0 && hidden > 0;
}

struct Recall {
  std::size_t crossed = 0;
  std::size_t found = 0;
  std::size_t marked = 0;
};

Recall recall_of(const ElementMesh& elements, const mesh::PatchRays& rays, const mesh::LightSample& light,
                 const std::vector<std::uint8_t>& marked) {
  const std::vector<ElementId> leaves = elements.leaves();
  std::vector<char> truth(leaves.size());
  tbb::parallel_for(std::size_t{0}, leaves.size(),
                    [&](std::size_t i) { truth[i] = crossed(elements, rays, light, leaves[i]) ? 1 : 0; });
  Recall recall;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    recall.crossed += truth[i] != 0 ? 1U : 0U;
    recall.found += truth[i] != 0 && marked[leaves[i]] != 0 ? 1U : 0U;
    recall.marked += marked[leaves[i]];
  }
  return recall;
}

TEST(Shadows, AreMarkedWhereverBruteForceFindsThem) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const ElementMesh elements = elements_of(boxes_in_light(seed, 5), 1, 0.25);
    const mesh::PatchRays rays(elements);
    const auto materials = one_light();
    const auto lights = mesh::light_samples(elements, materials, 4);
    ASSERT_EQ(lights.size(), 5U);
    const auto light = std::span(lights).first(1);
    std::vector<std::uint8_t> marked(elements.element_count(), 0);
    mesh::mark_crossed(elements, mesh::shadow_lines(elements, rays, light, 0.25 * kUnit), kBuilderTolerance, marked);
    const Recall recall = recall_of(elements, rays, light[0], marked);
    EXPECT_GT(recall.crossed, 100U);
    EXPECT_EQ(recall.found, recall.crossed) << "seed " << seed;
    EXPECT_LE(recall.marked, 2 * recall.crossed) << "seed " << seed << ": little else is marked";

    std::vector<std::uint8_t> scanned(elements.element_count(), 0);
    mesh::mark_steps(mesh::hemicube(elements, rays, light[0], 128), scanned);
    const Recall raster = recall_of(elements, rays, light[0], scanned);
    RecordProperty("hemicube_recall_percent", static_cast<int>(100 * raster.found / raster.crossed));
    EXPECT_GT(raster.found, 0U);
    EXPECT_LT(raster.found, raster.crossed) << "a raster misses some";
  }
}

// A pole thinner than any element, whose shadow no corner of an element feels.
TEST(Shadows, OfThinPolesAreMarked) {
  ConformingBuilder builder;
  builder.add_face(rectangle(0, 0, 10, 10));
  builder.add_box(at(3.03, 1, 2), at(3.18, 9, 2.15));
  builder.use_material(1);
  builder.add_face(reversed(rectangle(5, 5, 5.2, 5.2, 9)));
  const ElementMesh elements = elements_of(builder, 2, 0.5);
  const mesh::PatchRays rays(elements);
  const auto materials = one_light();
  const auto lights = mesh::light_samples(elements, materials, 1);
  std::vector<std::uint8_t> marked(elements.element_count(), 0);
  mesh::mark_crossed(elements, mesh::shadow_lines(elements, rays, std::span(lights).first(1), 0.5 * kUnit),
                     kBuilderTolerance, marked);
  const Recall recall = recall_of(elements, rays, lights[0], marked);
  EXPECT_GT(recall.crossed, 10U);
  EXPECT_EQ(recall.found, recall.crossed);
}

TEST(Shadows, MakeEmeshDivideMore) {
  const ConformingBuilder builder = boxes_in_light(4, 4);
  const auto materials = one_light();
  const auto leaves_with = [&](mesh::ShadowSearch search) {
    ElementMesh elements(meshed(builder, 1));
    const auto outcome =
        mesh::emesh(elements, {.longest_edge = 0.5, .shadow_edge = 0.125, .search = search, .materials = materials});
    EXPECT_EQ(outcome.problem, "");
    return elements.leaves().size();
  };
  const std::size_t even = leaves_with(mesh::ShadowSearch::None);
  const std::size_t silhouettes = leaves_with(mesh::ShadowSearch::Silhouettes);
  EXPECT_GT(silhouettes, even + 500);
  EXPECT_LT(silhouettes, 10 * even);
  EXPECT_GT(leaves_with(mesh::ShadowSearch::Hemicube), even);
}

TEST(Shadows, AreNotLookedForWithoutLight) {
  ElementMesh elements(meshed(boxes_in_light(4, 2), 1));
  EXPECT_EQ(mesh::emesh(elements, {.longest_edge = 0.5, .shadow_edge = 0.125}).shadow_lines, 0U);
}

}  // namespace
}  // namespace rad::tests
