// What corners have is kept through repair: exact where nothing moved, the affine map of the face at every cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "corpus/hard/kinds.h"
#include "scene/scene_builder.h"
#include "scene/texture_map.h"
#include "tests/support/affine_textures.h"
#include "tests/support/corner_values_text.h"
#include "tests/support/random_scenes.h"
#include "tests/support/repaired_checks.h"
#include "tests/support/scene_invariants.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

using scene::dvec2;
using scene::dvec3;
using scene::Pieces;
using scene::Scene;
using tests::AffineTextures;

// T: points move by 4 T, where they are merged by some more; then a value is that of the nearest place of its face.
constexpr double kMoved = 2 * 8;

struct Textured {
  Scene scene;
  AffineTextures textures{0};
  std::vector<std::uint32_t> map_of_face;
};

Textured textured(Scene scene, std::uint64_t seed) {
  Textured result{std::move(scene), AffineTextures(seed), {}};
  tests::LatticeRandom random(seed);
  for (std::size_t i = 0; i < result.scene.faces.size(); ++i) {
    result.map_of_face.push_back(static_cast<std::uint32_t>(random.between(0, AffineTextures::kMaps - 1)));
  }
  result.textures.put_on(result.scene, result.map_of_face);
  return result;
}

// The map that every piece of a face of the result came from; kMaps where there are several.
std::uint32_t map_of(const scene::ConformingModel& model, const scene::ConformingFace& face, const Textured& input) {
  std::set<std::uint32_t> maps;
  for (std::uint32_t i = 0; i < face.triangle_count; ++i) {
    maps.insert(input.map_of_face[model.origins[face.first_triangle + i].source]);
  }
  return maps.size() == 1 ? *maps.begin() : AffineTextures::kMaps;
}

void expect_map(const Scene& written, scene::FaceId id, const Textured& input, std::uint32_t map, double tolerance) {
  const std::vector<dvec2> values = tests::texture_of(written, id);
  std::size_t i = 0;
  for (const scene::Loop& loop : written.loops_of(written.faces[id])) {
    for (const scene::VertexId vertex : written.corners_of(loop)) {
      ASSERT_LT(i, values.size()) << "face " << id << " has no texture coordinates";
      const dvec2 off = values[i++] - input.textures.at(map, written.vertices[vertex]);
      const double allowed = scene::kTextureTolerance + kMoved * tolerance * input.textures.steepest(map);
      EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), allowed) << "face " << id;
    }
  }
}

void expect_kept(const Textured& input, double tolerance) {
  const Repaired result = tests::repaired(input.scene, tolerance);
  if (result.model.faces.empty()) return;
  const Scene polygons = scene::repaired_scene(result.model, input.scene, Pieces::Faces);
  const Scene triangles = scene::repaired_scene(result.model, input.scene, Pieces::Triangles);
  EXPECT_EQ(tests::broken_invariant(polygons), "");
  EXPECT_EQ(tests::broken_invariant(triangles), "");
  for (scene::FaceId id = 0; id < triangles.faces.size(); ++id) {
    const std::vector<dvec2> values = tests::texture_of(triangles, id);
    ASSERT_FALSE(values.empty());
    const auto map = static_cast<std::uint32_t>(std::lround(values[0].x / AffineTextures::kApart));
    ASSERT_LT(map, AffineTextures::kMaps);
    expect_map(triangles, id, input, map, tolerance);
  }
  for (scene::FaceId id = 0; id < result.model.faces.size(); ++id) {
    const scene::ConformingFace& face = result.model.faces[id];
    const std::uint32_t map = map_of(result.model, face, input);
    ASSERT_LT(map, AffineTextures::kMaps) << "a seam was lost in face " << id;
    expect_map(polygons, id, input, map, tolerance);
  }
}

void expect_same_in_any_order(const Textured& input, double tolerance) {
  const Scene shuffled = tests::rewritten(input.scene, 5);
  const Scene a = scene::repaired_scene(tests::repaired(input.scene, tolerance).model, input.scene, Pieces::Triangles);
  const Scene b = scene::repaired_scene(tests::repaired(shuffled, tolerance).model, shuffled, Pieces::Triangles);
  EXPECT_TRUE(a.vertices == b.vertices);
  EXPECT_TRUE(a.attributes.texture_coordinates.table == b.attributes.texture_coordinates.table);
  EXPECT_TRUE(a.attributes.texture_coordinates.row_of_corner == b.attributes.texture_coordinates.row_of_corner);
}

TEST(Attributes, FollowTheirMapThroughCoarseScenes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Textured input = textured(tests::coarse_scene(seed), seed);
    expect_kept(input, tests::kSceneTolerance);
    expect_same_in_any_order(input, tests::kSceneTolerance);
  }
}

TEST(Attributes, FollowTheirMapThroughFineScenes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_kept(textured(tests::fine_scene(seed), seed), tests::kSceneTolerance);
  }
}

TEST(Attributes, FollowTheirMapThroughHardScenes) {
  for (const corpus::HardKind& kind : corpus::hard_kinds()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(std::string(kind.name) + " seed " + std::to_string(seed));
      const corpus::HardScene hard = corpus::hard_scene(kind, seed);
      expect_kept(textured(hard.scene, seed), hard.tolerance);
    }
  }
}

/// Two sheets that cross in the middle of both, far from every corner.
Scene crossing_sheets() {
  scene::SceneBuilder builder("", "obj");
  builder.add_section({});
  const auto add = [&](const std::vector<dvec3>& corners) {
    std::vector<scene::VertexId> ids;
    for (const dvec3& corner : corners) ids.push_back(builder.add_vertex(corner));
    builder.use_object(builder.object("sheet " + std::to_string(ids[0])));
    builder.add_face(ids, 0);
  };
  add({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}});
  add({{0, -2, -3}, {0, 2, -3}, {0, 2, 3}, {0, -2, 3}});
  return builder.take();
}

TEST(Attributes, AreExactAtKeptCornersAndAffineAtCuts) {
  const Textured input = textured(crossing_sheets(), 3);
  const Repaired result = tests::repaired(input.scene, 0.001);
  EXPECT_FALSE(result.untouched);
  const Scene written = scene::repaired_scene(result.model, input.scene, Pieces::Faces);
  std::size_t kept = 0, cut = 0;
  for (scene::FaceId id = 0; id < written.faces.size(); ++id) {
    const std::uint32_t map = input.map_of_face[result.model.faces[id].source];
    const std::vector<dvec2> values = tests::texture_of(written, id);
    std::size_t i = 0;
    for (const scene::Loop& loop : written.loops_of(written.faces[id])) {
      for (const scene::VertexId vertex : written.corners_of(loop)) {
        const dvec3& place = written.vertices[vertex];
        const dvec2 expected = input.textures.at(map, place);
        const bool is_old = std::ranges::find(input.scene.vertices, place) != input.scene.vertices.end();
        ++(is_old ? kept : cut);
        if (is_old) {
          EXPECT_EQ(values[i], expected);
        } else {
          EXPECT_NEAR(glm::distance(values[i], expected), 0, 1e-12);
        }
        ++i;
      }
    }
  }
  EXPECT_GE(kept, 8u);
  EXPECT_GE(cut, 2u);
}

/// A row of unit squares in one plane, one object and material; `value_at` gives their texture coordinates.
template <typename ValueAt>
Scene row_of_squares(std::size_t count, ValueAt value_at) {
  scene::SceneBuilder builder("", "obj");
  builder.add_section({});
  std::vector<scene::VertexId> ids;
  for (std::size_t i = 0; i <= count; ++i) {
    ids.push_back(builder.add_vertex({static_cast<double>(i), 0, 0}));
    ids.push_back(builder.add_vertex({static_cast<double>(i), 1, 0}));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::array corners{ids[2 * i], ids[2 * i + 2], ids[2 * i + 3], ids[2 * i + 1]};
    std::vector<scene::RowId> rows;
    for (const scene::VertexId id : corners) {
      rows.push_back(builder.add_texture_coordinates(value_at(i, builder.scene().vertices[id])));
    }
    builder.add_face(corners, 0);
    builder.set_texture_coordinates(rows);
  }
  return builder.take();
}

// Put together whether it is needed or not.
std::size_t faces_of(const Scene& scene) {
  RepairOptions options;
  options.filters = {};
  return repair(scene, {}, options).model.faces.size();
}

TEST(Attributes, OneMapMergesAndASeamStays) {
  const auto plain = [](std::size_t, const dvec3& p) { return dvec2(p.x / 8, p.y / 8); };
  EXPECT_EQ(faces_of(row_of_squares(8, plain)), 1u);
  const auto tiles = [](std::size_t i, const dvec3& p) { return dvec2(p.x - static_cast<double>(i), p.y); };
  EXPECT_EQ(faces_of(row_of_squares(8, tiles)), 8u);
  const auto halves = [](std::size_t i, const dvec3& p) { return dvec2(p.x / 8 + (i < 3 ? 0 : 5), p.y / 8); };
  EXPECT_EQ(faces_of(row_of_squares(8, halves)), 2u);
}

// Each square agrees with the next to half a texel, but the last not with the first: an error must not add up.
TEST(Attributes, ABentRowIsNotMergedToOneFace) {
  constexpr double kBend = 0.9 * scene::kTextureTolerance;
  const auto bent = [](std::size_t, const dvec3& p) { return dvec2(p.x / 8 + kBend / 2 * p.x * p.x, p.y / 8); };
  const std::size_t faces = faces_of(row_of_squares(64, bent));
  EXPECT_GT(faces, 16u);
  EXPECT_LT(faces, 64u);
}

TEST(Attributes, NormalsAreTurnedWithTheirFaceAndUnitAtCuts) {
  Scene scene = crossing_sheets();
  auto& normals = scene.attributes.normals;
  for (std::uint32_t corner = 0; corner < scene.corners.size(); ++corner) {
    normals.row_of_corner.push_back(corner);
    const dvec3 flat = corner < 4 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    normals.table.push_back(glm::normalize(flat + 0.1 * scene.vertices[scene.corners[corner]]));
  }
  const Scene written = scene::repaired_scene(tests::repaired(scene, 0.001).model, scene, Pieces::Triangles);
  ASSERT_FALSE(written.attributes.normals.empty());
  for (scene::FaceId id = 0; id < written.faces.size(); ++id) {
    const auto corners = written.corners_of(written.loops_of(written.faces[id])[0]);
    const dvec3 front = glm::cross(written.vertices[corners[1]] - written.vertices[corners[0]],
                                   written.vertices[corners[2]] - written.vertices[corners[0]]);
    for (const dvec3& normal : tests::normals_of(written, id)) {
      EXPECT_NEAR(glm::length(normal), 1, 1e-12);
      EXPECT_GT(glm::dot(normal, front), 0);
    }
  }
}

TEST(Attributes, NormalsOfATurnedFaceAreNegated) {
  scene::SceneBuilder builder("", "obj");
  builder.add_section({});
  for (int i = 0; i < 8; ++i) builder.add_vertex({i & 1 ? 2.0 : 0.0, i & 2 ? 2.0 : 0.0, i & 4 ? 2.0 : 0.0});
  const std::array<std::array<scene::VertexId, 4>, 6> sides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 6, 7, 5}}};  // the last is turned
  for (const auto& side : sides) builder.add_face(side, 0);
  Scene scene = builder.take();
  auto& normals = scene.attributes.normals;
  const std::array<dvec3, 6> stored{dvec3(-1, 0, 0), {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, -1}};
  for (std::uint32_t corner = 0; corner < scene.corners.size(); ++corner) {
    normals.row_of_corner.push_back(corner / 4);
  }
  normals.table.assign(stored.begin(), stored.end());
  const Repaired result = tests::repaired(scene, 0.001);
  EXPECT_FALSE(result.untouched);
  const Scene written = scene::repaired_scene(result.model, scene, Pieces::Faces);
  std::multiset<double> heights;
  for (scene::FaceId id = 0; id < written.faces.size(); ++id) {
    const auto values = tests::normals_of(written, id);
    ASSERT_EQ(values.size(), 4u);
    heights.insert(values[0].z);
  }
  EXPECT_EQ(heights, (std::multiset<double>{-1, 0, 0, 0, 0, 1}));
}

TEST(Attributes, OfScenesWithoutAnyAreNone) {
  const Scene scene = tests::coarse_scene(4);
  const Scene written =
      scene::repaired_scene(tests::repaired(scene, tests::kSceneTolerance).model, scene, Pieces::Faces);
  EXPECT_TRUE(written.attributes.empty());
  EXPECT_TRUE(written.attributes.texture_coordinates.table.empty());
}

}  // namespace
}  // namespace rad::repair
