#include "writers/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "tests/writers/written_files.h"

namespace rad::writers {
namespace {

using namespace tests;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Ply, HasRadiosityAndColourAtEveryVertex) {
  const auto path = fresh_folder("ply_light") / "lit.ply";
  const scene::Scene scene = two_plates();
  scene::VertexLight light = light_on(scene);
  light.colour[0] = {0, 0.002, 0.5};
  light.colour[5] = {1, 0.25, -0.0};
  ASSERT_EQ(write_ply({.scene = scene, .light = &light}, path).problem, "");
  const std::string bytes = bytes_of(path);
  EXPECT_THAT(bytes, HasSubstr("comment radfix exposure=0.125 clampedShare=0.25 curve=linear\n"));
  EXPECT_THAT(bytes, HasSubstr("property double z\nproperty double B_r\nproperty double B_g\nproperty double B_b\n"
                               "property uchar red\nproperty uchar green\nproperty uchar blue\n"));
  const char* body = bytes.data() + bytes.find("end_header\n") + 11;
  constexpr std::size_t kVertexBytes = 6 * 8 + 3;
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> values;
    std::memcpy(values.data(), body + i * kVertexBytes, sizeof values);
    EXPECT_EQ(bits_of({values[0], values[1], values[2]}), bits_of(scene.vertices[i]));
    EXPECT_EQ(bits_of({values[3], values[4], values[5]}), bits_of(light.radiosity[i]));
  }
  // 12.92 × 0.002 × 255 = 6.6; sRGB of 0.5 is 0.7354, of 0.25 it is 0.5371.
  EXPECT_EQ(std::string(body + 48, 3), std::string("\x00\x07\xBC", 3));
  EXPECT_EQ(std::string(body + 5 * kVertexBytes + 48, 3), std::string("\xFF\x89\x00", 3));
  EXPECT_EQ(readers::read_file(path).scene.faces.size(), 3u);
  EXPECT_FALSE(readers::read_file(path).scene.single_precision);
}

TEST(Ply, CountsCornersInFourBytesWhereOneIsTooShort) {
  const auto path = fresh_folder("ply_corners") / "disc.ply";
  for (const int corners : {255, 256, 1000}) {
    scene::SceneBuilder builder("", "obj");
    std::vector<scene::VertexId> ids;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      ids.push_back(builder.add_vertex({std::cos(angle), std::sin(angle), 0}));
    }
    builder.add_face(ids, 0);
    const scene::Scene scene = builder.take();
    ASSERT_EQ(write_ply({scene}, path).problem, "");
    EXPECT_THAT(bytes_of(path), HasSubstr(corners == 255 ? "list uchar int" : "list uint int"));
    EXPECT_EQ(polygons_of(readers::read_file(path).scene), polygons_of(scene));
  }
}

TEST(Ply, KeepsCommentsOnTheirLine) {
  const auto path = fresh_folder("ply_comments") / "c.ply";
  const scene::Scene scene = two_plates();
  const std::vector<std::string> comments{"one\nend_header", "two"};
  ASSERT_EQ(write_ply({.scene = scene, .comments = comments, .marked_incomplete = true}, path).problem, "");
  EXPECT_THAT(bytes_of(path), StartsWith("ply\nformat binary_little_endian 1.0\ncomment written by radfix "));
  EXPECT_THAT(bytes_of(path), HasSubstr("comment radfix incomplete\ncomment one_end_header\ncomment two\nelement"));
  EXPECT_EQ(polygons_of(readers::read_file(path).scene), polygons_of(scene));
}

}  // namespace
}  // namespace rad::writers
