#include "bake/png.h"

#include <gtest/gtest.h>
#include <png.h>

namespace rad::bake {
namespace {

TEST(SrgbCode, Curve_KnownPoints) {
  EXPECT_EQ(srgb_code(0), 0);
  EXPECT_EQ(srgb_code(1), 255);
  EXPECT_EQ(srgb_code(0.5), 188);
  EXPECT_EQ(srgb_code(0.2158605), 128);
  EXPECT_EQ(srgb_code(0.001), 3);
  EXPECT_EQ(srgb_code(-3), 0);
  EXPECT_EQ(srgb_code(7), 255);
}

TEST(PngBytes, Picture_DecodesBack) {
  const Image image{
      .width = 2, .height = 3, .pixels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}, {2, -1, 0.001}, {1, 1, 1}}};
  const std::string bytes = png_bytes(image);
  png_image decoded{};
  decoded.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&decoded, bytes.data(), bytes.size()));
  EXPECT_EQ(decoded.width, 2u);
  EXPECT_EQ(decoded.height, 3u);
  decoded.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(decoded));
  ASSERT_TRUE(png_image_finish_read(&decoded, nullptr, pixels.data(), 0, nullptr));
  const std::vector<std::uint8_t> expected{255, 0, 0, 0, 255, 0, 0, 0, 255, 188, 188, 188, 255, 0, 3, 255, 255, 255};
  EXPECT_EQ(pixels, expected);
}

TEST(PngBytes, NoPixels_NoBytes) { EXPECT_TRUE(png_bytes(Image{}).empty()); }

TEST(PngBytes, SamePicture_SameBytes) {
  const Image image{.width = 2, .height = 1, .pixels = {{0.3, 0.2, 0.1}, {1, 0, 1}}};
  EXPECT_EQ(png_bytes(image), png_bytes(image));
  EXPECT_EQ(png_bytes(image).find("tIME"), std::string::npos);
}

}  // namespace
}  // namespace rad::bake
