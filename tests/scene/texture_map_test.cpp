#include "scene/texture_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scene/scene_builder.h"

namespace rad::scene {
namespace {

/// Faces in the plane z = 0 whose texture coordinates a function gives.
class Plane {
 public:
  template <typename TextureAt>
  void add(const std::vector<dvec2>& corners, TextureAt texture_at) {
    std::vector<VertexId> ids;
    std::vector<RowId> rows;
    for (const dvec2& corner : corners) {
      ids.push_back(builder_.add_vertex({corner.x, corner.y, 0}));
      rows.push_back(builder_.add_texture_coordinates(texture_at(corner)));
    }
    builder_.add_face(ids, 0);
    builder_.set_texture_coordinates(rows);
  }
  void add_plain(const std::vector<dvec2>& corners) {
    std::vector<VertexId> ids;
    for (const dvec2& corner : corners) ids.push_back(builder_.add_vertex({corner.x, corner.y, 0}));
    builder_.add_face(ids, 0);
  }
  Scene take() { return builder_.take(); }

 private:
  SceneBuilder builder_{"", "obj"};
};

const std::vector<dvec2> kLeft{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, kRight{{4, 0}, {6, 0}, {6, 4}, {4, 4}};
dvec2 sheared(const dvec2& p) { return {0.25 * p.x + 0.1 * p.y + 3, 0.5 * p.y - 0.2 * p.x}; }

bool same(const Scene& scene, double tolerance = 0) {
  return same_texture_map(scene, scene.faces[0], scene.faces[1], tolerance);
}

TEST(TextureMap, IsOneWhereCoordinatesGoOn) {
  Plane plane;
  plane.add(kLeft, sheared);
  plane.add(kRight, sheared);
  EXPECT_TRUE(same(plane.take()));
}

TEST(TextureMap, DiffersBeyondHalfATexel) {
  for (const double off : {0.9, 1.1}) {
    Plane plane;
    plane.add(kLeft, sheared);
    plane.add(kRight, [&](const dvec2& p) { return sheared(p) + dvec2(off * kTextureTolerance, 0); });
    EXPECT_EQ(same(plane.take()), off < 1);
  }
}

TEST(TextureMap, DiffersNotWhereTheImageMovesLessThanTheTolerance) {
  const auto steep = [](const dvec2& p) { return 1000.0 * p; };
  for (const double off : {0.9, 1.1}) {
    Plane plane;
    plane.add(kLeft, steep);
    plane.add(kRight, [&](const dvec2& p) { return steep(p + dvec2(off * 0.01, 0)); });
    EXPECT_EQ(same(plane.take(), 0.01), off < 1) << "T is 0.01";
  }
}

TEST(TextureMap, DiffersFromNoneAndAgreesWithItself) {
  Plane plane;
  plane.add(kLeft, sheared);
  plane.add_plain(kRight);
  plane.add_plain(kLeft);
  const Scene scene = plane.take();
  EXPECT_FALSE(same(scene));
  EXPECT_TRUE(same_texture_map(scene, scene.faces[1], scene.faces[2], 0));
  EXPECT_TRUE(same_texture_map(scene, scene.faces[0], scene.faces[0], 0));
  EXPECT_FALSE(TextureMap::of(scene, scene.faces[1]));
}

TEST(TextureMap, ThatIsNotAffineAgreesWithNone) {
  Plane plane;
  plane.add(kLeft, [](const dvec2& p) { return dvec2(p.x * p.y, p.y); });
  plane.add(kRight, [](const dvec2& p) { return dvec2(4 * p.y, p.y); });
  const Scene scene = plane.take();
  EXPECT_FALSE(same(scene));
  const auto map = TextureMap::of(scene, scene.faces[0]);
  ASSERT_TRUE(map);
  EXPECT_FALSE(map->fits(scene, scene.faces[0], 0));
}

TEST(TextureMap, IsNoneOnALine) {
  Plane plane;
  plane.add({{0, 0}, {1, 1}, {2, 2}}, sheared);
  const Scene scene = plane.take();
  EXPECT_FALSE(TextureMap::of(scene, scene.faces[0]));
}

TEST(TextureMap, OfTheLargerFaceLeadsWhateverTheOrder) {
  for (const bool swapped : {false, true}) {
    Plane plane;
    plane.add(swapped ? kRight : kLeft, sheared);
    plane.add(swapped ? kLeft : kRight, sheared);
    const Scene scene = plane.take();
    const auto first = TextureMap::of(scene, scene.faces[0]), second = TextureMap::of(scene, scene.faces[1]);
    EXPECT_EQ(first->leads(*second), !swapped);
    EXPECT_EQ(second->leads(*first), swapped);
    EXPECT_FALSE(first->leads(*first));
  }
}

}  // namespace
}  // namespace rad::scene
