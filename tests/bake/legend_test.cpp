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

TEST(Legend, HasAllColoursOfTheScale_AndThePictureBesideIt) {
  const Image plain = grey(320, 240);
  const Image image = with_legend(plain, 20);
  ASSERT_EQ(image.height, plain.height);
  ASSERT_GT(image.width, plain.width);
  const std::uint32_t strip = image.width - plain.width;
  for (std::uint32_t row = 0; row < plain.height; ++row) {
    for (std::uint32_t column = 0; column < plain.width; ++column) {
      ASSERT_EQ(image.at(strip + column, row), plain.at(column, row));
    }
  }
  for (const double value : {0.1, 0.5, 0.9}) {
    const dvec3 wanted = scene::false_colour(value);
    EXPECT_TRUE(std::ranges::any_of(image.pixels, [&](const dvec3& pixel) {
      return std::abs(pixel.x - wanted.x) + std::abs(pixel.y - wanted.y) + std::abs(pixel.z - wanted.z) < 0.02;
    })) << value;
  }
}

TEST(Legend, PicturesTooLowForIt_StayAsTheyAre) {
  for (const std::uint32_t height : {1U, 100U})
    EXPECT_EQ(with_legend(grey(960, height), 20).pixels, grey(960, height).pixels);
}

}  // namespace
}  // namespace rad::bake
