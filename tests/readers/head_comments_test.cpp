#include "readers/head_comments.h"

#include <gtest/gtest.h>

#include <initializer_list>

#include "readers/unit_comment.h"
#include "scene/scene.h"

namespace rad::readers {
namespace {

scene::Scene scene_with(std::initializer_list<std::string_view> comments) {
  HeadComments head;
  for (const std::string_view comment : comments) head.read(comment);
  scene::Scene scene = scene::empty_scene("a.obj", "obj");
  head.apply(scene);
  return scene;
}

TEST(UnitComment, LengthInMetres) {
  EXPECT_EQ(metres_of_comment("# units: 0.9144 m"), 0.9144);
  EXPECT_EQ(metres_of_comment("units: 1 m"), 1);
  EXPECT_EQ(metres_of_comment("units: m"), 1);
  for (const std::string_view none : {"units: 0 m", "units: -1 m", "units: nan m", "units: inf m", "units: 1 x m",
                                      "units:  m m", "units 1 m", "units: 1m"}) {
    EXPECT_EQ(metres_of_comment(none), std::nullopt) << none;
  }
}

TEST(UnitComment, UpAxis) {
  EXPECT_EQ(up_axis_of_comment("# up: z"), scene::UpAxis::Z);
  EXPECT_EQ(up_axis_of_comment("Up Axis = Y"), scene::UpAxis::Y);
  for (const std::string_view none : {"up", "up: x", "up z", "upper: z", "go up: z"}) {
    EXPECT_EQ(up_axis_of_comment(none), scene::UpAxis::Unknown) << none;
  }
}

TEST(HeadComments, AreTakenTogether) {
  const scene::Scene scene = scene_with({"made by hand", "units: mm", "up: z", "radfix T=0.25 h=0.0625 origin=0 0 0"});
  EXPECT_EQ(scene.metres_per_unit, 0.001);
  EXPECT_EQ(scene.up, scene::UpAxis::Z);
  EXPECT_TRUE(scene.recorded.has_value());
}

TEST(HeadComments, WhatContradictsItselfIsNotTaken) {
  const scene::Scene scene = scene_with({"units: mm", "up: z", "up: y", "units: m", "units: mm"});
  EXPECT_EQ(scene.metres_per_unit, std::nullopt);
  EXPECT_EQ(scene.up, scene::UpAxis::Unknown);
  const scene::Scene twice = scene_with({"units: mm", "units: 0.001 m", "up: y", "up axis: y"});
  EXPECT_EQ(twice.metres_per_unit, 0.001);
  EXPECT_EQ(twice.up, scene::UpAxis::Y);
}

}  // namespace
}  // namespace rad::readers
