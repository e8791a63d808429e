#include "bake/marks.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "bake/vertex_light.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Severity;

constexpr std::array kSeverities{Severity::Note, Severity::Warning, Severity::Error};
const dvec3 kGrey{0.3, 0.3, 0.3};

Image grey(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<dvec3>(std::size_t{width} * height, kGrey)};
}

/// Which pixels have the colour of the severity, as rows of text.
std::string shape_of(Severity severity) {
  Image image = grey(24, 24);
  draw_sign(image, {12, 12}, severity, 8);
  std::string shape;
  for (std::uint32_t y = 0; y < 24; ++y) {
    for (std::uint32_t x = 0; x < 24; ++x) shape += image.at(x, y) == severity_colour(severity) ? '#' : '.';
    shape += '\n';
  }
  return shape;
}

TEST(Marks, SignsDifferInShapeAndLightness) {
  std::set<std::string> shapes;
  for (const Severity severity : kSeverities) {
    const std::string shape = shape_of(severity);
    EXPECT_GT(std::count(shape.begin(), shape.end(), '#'), 60) << shape;
    shapes.insert(shape);
    for (const Severity other : kSeverities) {
      if (other == severity) continue;
      // Without hue, as contrast is reckoned on the web.
      const double a = luminance(severity_colour(severity)) + 0.05, b = luminance(severity_colour(other)) + 0.05;
      EXPECT_GT(std::max(a, b) / std::min(a, b), 1.2);
    }
  }
  EXPECT_EQ(shapes.size(), 3u);
}

TEST(Marks, SignsHaveALightCasingAndLeaveTheRest) {
  Image image = grey(40, 40);
  draw_sign(image, {20, 20}, Severity::Note, 8);
  EXPECT_EQ(image.at(20, 20), severity_colour(Severity::Note));
  EXPECT_EQ(image.at(2, 2), kGrey);
  EXPECT_GT(image.at(27, 20).x, 0.5) << "casing";
}

TEST(Marks, SignsBesideThePicture_AreCutOff) {
  for (const glm::dvec2 at : {glm::dvec2{-3, 5}, glm::dvec2{43, 45}, glm::dvec2{1e9, -1e9}, glm::dvec2{0, 0}}) {
    Image image = grey(40, 40);
    draw_sign(image, at, Severity::Error, 8);
    EXPECT_EQ(image.at(20, 20), kGrey);
  }
}

TEST(Marks, LinesRunFromEndToEnd) {
  Image image = grey(60, 40);
  const dvec3 colour{0.5, 0, 0};
  draw_line(image, {10, 30}, {50, 10}, colour);
  for (const double share : {0.0, 0.3, 0.5, 1.0}) {
    const auto x = static_cast<std::uint32_t>(10 + 40 * share), y = static_cast<std::uint32_t>(30 - 20 * share);
    EXPECT_EQ(image.at(x, y), colour) << share;
  }
  EXPECT_EQ(image.at(3, 34), kGrey) << "beyond the end";
  EXPECT_EQ(image.at(30, 33), kGrey) << "beside the line";
}

}  // namespace
}  // namespace rad::bake
