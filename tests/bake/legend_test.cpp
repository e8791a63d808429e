#include "bake/legend.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/display_curve.h"

namespace rad::bake {
namespace {

using geom::dvec3;

Image grey(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<dvec3>(std::size_t{width} * height, dvec3(0.3))};
}

TEST(RoundAbove, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_above(1), 1);
  EXPECT_DOUBLE_EQ(round_above(1.1), 2);
  EXPECT_DOUBLE_EQ(round_above(7.5), 10);
  EXPECT_DOUBLE_EQ(round_above(0.0401), 0.05);
  EXPECT_DOUBLE_EQ(round_above(2000), 2000);
}

TEST(Legend, HasAllColoursOfTheScale_AndLeavesTheRestOfThePicture) {
  Image image = grey(960, 720);
  draw_legend(image, 20);
  for (const double value : {0.1, 0.5, 0.9}) {
    const dvec3 wanted = scene::false_colour(value);
    EXPECT_TRUE(std::ranges::any_of(image.pixels, [&](const dvec3& pixel) {
      return std::abs(pixel.x - wanted.x) + std::abs(pixel.y - wanted.y) + std::abs(pixel.z - wanted.z) < 0.01;
    })) << value;
  }
  EXPECT_EQ(image.at(500, 300), dvec3(0.3));
  EXPECT_EQ(image.at(20, 20), dvec3(0.3));
}

TEST(Legend, PicturesTooSmallForIt_StayAsTheyAre) {
  for (const auto& [width, height] : {std::pair{200U, 720U}, std::pair{960U, 100U}, std::pair{1U, 1U}}) {
    Image image = grey(width, height);
    draw_legend(image, 20);
    EXPECT_EQ(image.pixels, grey(width, height).pixels);
  }
}

}  // namespace
}  // namespace rad::bake
