#include "bake/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "tests/bake/drawn_scenes.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::SceneBuilder;
using scene::UpAxis;
using tests::Facing;

constexpr double kAspect = 4.0 / 3;

/// How far beyond the picture's border the point is seen: at most 1 inside it.
double reach_in_picture(const Camera& camera, const dvec3& point) {
  const CameraFrame frame = frame_of(camera);
  const dvec3 from_eye = point - camera.position;
  const double depth = -glm::dot(from_eye, frame.backward);
  if (depth <= 0) return std::numeric_limits<double>::infinity();
  const double slope = std::tan(camera.vertical_field_of_view_deg * std::numbers::pi / 360);
  const double across = std::abs(glm::dot(from_eye, frame.right)) / (depth * slope * kAspect);
  const double above = std::abs(glm::dot(from_eye, frame.up)) / (depth * slope);
  return std::max(across, above);
}

TEST(AutomaticCamera, Box_IsFramedTightly) {
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
    const Scene scene = tests::box_scene(Facing::Outward, up);
    const Camera camera = automatic_camera(scene, kAspect);
    double farthest = 0;
    for (const dvec3& vertex : scene.vertices) farthest = std::max(farthest, reach_in_picture(camera, vertex));
    EXPECT_LE(farthest, 0.96);
    EXPECT_GE(farthest, 0.9);
  }
}

RC_GTEST_PROP(AutomaticCamera, AnyBox_IsInThePicture, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000); };
  const auto length = [] { return *rc::gen::inRange(0, 1000); };
  const dvec3 low(number(), number(), number());
  const dvec3 high = low + dvec3(length(), length(), length());
  SceneBuilder builder("box.obj", "obj");
  tests::add_box(builder, low, high, Facing::Outward);
  const Camera camera = automatic_camera(builder.scene(), kAspect);
  for (const dvec3& vertex : builder.scene().vertices) RC_ASSERT(reach_in_picture(camera, vertex) <= 1);
}

TEST(AutomaticCamera, OpenRoom_IsSeenFromItsOpenSide) {
  // Without the side at high x: only from there do the inward faces show.
  Scene scene = tests::box_scene(Facing::Inward);
  scene.faces.pop_back();
  EXPECT_GT(automatic_camera(scene, kAspect).position.x, 4);
  Scene turned = tests::box_scene(Facing::Inward);
  turned.faces.erase(turned.faces.begin() + 4);
  EXPECT_LT(automatic_camera(turned, kAspect).position.x, 0);
}

TEST(AutomaticCamera, LitSide_IsSeen) {
  const Scene scene = tests::box_scene(Facing::Outward);
  const auto view_of_side = [&](double lit_x) {
    scene::VertexLight light;
    for (const dvec3& vertex : scene.vertices) light.colour.emplace_back(vertex.x == lit_x ? 1.0 : 0.0);
    return automatic_camera(scene, kAspect, &light);
  };
  EXPECT_LT(view_of_side(0).position.x, 0);
  EXPECT_GT(view_of_side(4).position.x, 4);
}

TEST(AutomaticCamera, AllDark_IsAsWithoutLight) {
  const Scene scene = tests::box_scene(Facing::Outward);
  scene::VertexLight light;
  light.colour.assign(scene.vertices.size(), {0, 0, 0});
  EXPECT_EQ(automatic_camera(scene, kAspect, &light).position, automatic_camera(scene, kAspect).position);
}

TEST(AutomaticCamera, NothingToSee_StillACamera) {
  Scene scene = scene::empty_scene("none.obj", "obj");
  const Camera camera = automatic_camera(scene, kAspect);
  EXPECT_GT(glm::distance(camera.position, camera.target), 0);
}

TEST(UpDirection, Stated_IsTaken) {
  EXPECT_EQ(up_direction(tests::box_scene(Facing::Outward, UpAxis::Y)), dvec3(0, 1, 0));
  EXPECT_EQ(up_direction(tests::box_scene(Facing::Outward, UpAxis::Z)), dvec3(0, 0, 1));
}

TEST(UpDirection, StandsOnZeroAlongOneAxis_IsThatAxis) {
  SceneBuilder builder("lamp.obj", "obj");
  tests::add_box(builder, {-1, 0, -1}, {1, 6, 1}, Facing::Outward);
  EXPECT_EQ(up_direction(builder.scene()), dvec3(0, 1, 0));
}

TEST(UpDirection, NoSign_IsWhereFloorsLie) {
  EXPECT_EQ(up_direction(tests::box_scene(Facing::Inward, UpAxis::Unknown)), dvec3(0, 0, 1)) << "4 × 3 floor, 2 high";
  SceneBuilder builder("room.obj", "obj");
  tests::add_box(builder, {0, 0, 0}, {4, 2, 3}, Facing::Inward);
  EXPECT_EQ(up_direction(builder.scene()), dvec3(0, 1, 0));
}

TEST(FrameOf, LooksAlongUp_StillAtRightAngles) {
  const CameraFrame frame = frame_of({.position = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 0, 1}});
  EXPECT_NEAR(glm::length(frame.right), 1, 1e-15);
  EXPECT_NEAR(glm::dot(frame.right, frame.backward), 0, 1e-15);
  EXPECT_NEAR(glm::length(frame.up), 1, 1e-15);
  EXPECT_EQ(frame.backward, dvec3(0, 0, 1));
}

}  // namespace
}  // namespace rad::bake
