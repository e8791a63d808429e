#include "bake/viewport.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace rad::bake {
namespace {

using geom::dvec3;

const Camera kCamera{.position = {5, -3, 4}, .target = {0.5, 1, 0}, .up = {0, 0, 1}, .vertical_field_of_view_deg = 50};

TEST(Viewport, PixelOfAPointAlongARay_IsThatOfTheRay) {
  const Viewport view(kCamera, 640, 360);
  ASSERT_TRUE(view.has_view());
  for (const double x : {0.5, 100.25, 320.0, 639.5}) {
    for (const double y : {0.5, 180.0, 359.5}) {
      const dvec3 direction = view.ray_through(x, y);
      EXPECT_NEAR(glm::length(direction), 1, 1e-12);
      for (const double distance : {0.01, 3.0, 1e4}) {
        const auto pixel = view.pixel_of(kCamera.position + distance * direction);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, x, 1e-6);
        EXPECT_NEAR(pixel->y, y, 1e-6);
      }
    }
  }
}

TEST(Viewport, TargetIsInTheMiddle) {
  const auto pixel = Viewport(kCamera, 640, 360).pixel_of(kCamera.target);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 320, 1e-9);
  EXPECT_NEAR(pixel->y, 180, 1e-9);
}

TEST(Viewport, WhatIsBehind_IsNotSeen) {
  const Viewport view(kCamera, 640, 360);
  EXPECT_FALSE(view.pixel_of(2.0 * kCamera.position - kCamera.target));
  EXPECT_FALSE(view.pixel_of(kCamera.position));
}

TEST(Viewport, LinesAreMetWithinPixels) {
  const Viewport view(kCamera, 640, 360);
  const dvec3 from = kCamera.target, to = kCamera.target + dvec3{0, 0, 1};
  EXPECT_TRUE(view.passes_line(view.ray_through(320.4, 170), from, to, 0.5));
  EXPECT_FALSE(view.passes_line(view.ray_through(322, 170), from, to, 0.5));
}

TEST(Viewport, WithoutDirection_HasNoView) {
  EXPECT_FALSE(Viewport({.position = {1, 1, 1}, .target = {1, 1, 1}}, 8, 8).has_view());
}

}  // namespace
}  // namespace rad::bake
