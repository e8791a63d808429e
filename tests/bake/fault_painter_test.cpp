#include "bake/fault_painter.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "bake/marks.h"
#include "bake/viewport.h"
#include "tests/bake/drawn_scenes.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Finding;
using tests::Facing;

constexpr double kAspect = 1.5;

/// A fault at a point of the box from (0, 0, 0) to (4, 3, 2), of these faces: 0 lower, 1 upper side.
Finding fault_at(const dvec3& point, std::vector<scene::FaceId> faces) {
  Finding finding;
  finding.severity = scene::Severity::Error;
  finding.where.point = point;
  finding.where.places = {{point, std::nullopt}};
  finding.where.face_ids = std::move(faces);
  return finding;
}

FaultPicture small(const Camera& camera) {
  return {.width = 120, .height = 80, .samples_per_axis = 1, .camera = camera};
}

dvec3 colour_at(const Image& image, const glm::dvec2& pixel) {
  return image.at(static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y));
}

TEST(FaultPainter, DrawsASignWhereTheFaultIs) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const FaultPainter painter(scene);
  const Finding finding = fault_at({1, 1, 2}, {1});
  for (const Camera& camera : {painter.close_up(finding, kAspect).value(), painter.whole(finding, kAspect)}) {
    const FaultPicture view = small(camera);
    const DrawnFault fault = drawn(finding);
    const Image image = painter.picture(view, {&fault, 1});
    const auto pixel = Viewport(camera, view.width, view.height).pixel_of({1, 1, 2});
    ASSERT_TRUE(pixel && pixel->x >= 0 && pixel->x < view.width && pixel->y >= 0 && pixel->y < view.height);
    EXPECT_EQ(colour_at(image, *pixel), severity_colour(scene::Severity::Error));
    EXPECT_NE(colour_at(painter.picture(view, {}), *pixel), severity_colour(scene::Severity::Error));
  }
}

TEST(FaultPainter, HatchesTheFacesAtFault) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const FaultPainter painter(scene);
  const Finding finding = fault_at({1, 1, 2}, {1});
  const FaultPicture view = small(painter.whole(finding, kAspect));
  const DrawnFault fault = drawn(finding);
  const Image with = painter.picture(view, {&fault, 1}), without = painter.picture(view, {});
  const auto pixel = Viewport(view.camera, view.width, view.height).pixel_of({3, 2, 2}).value();
  const dvec3 before = colour_at(without, pixel), after = colour_at(with, pixel);
  EXPECT_DOUBLE_EQ(before.x, before.y) << "grey where nothing is at fault";
  EXPECT_GT(after.x, 1.15 * after.y) << "reddish, between the stripes too";
}

TEST(FaultPainter, LooksAtAPlaceFromWhereItIsSeen) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const FaultPainter painter(scene, BackFaces::Seen);
  for (const dvec3& place : {dvec3{2, 0, 1}, dvec3{2, 3, 1}, dvec3{0, 1, 1}, dvec3{4, 1, 1}, dvec3{2, 1, 0}}) {
    const Finding finding = fault_at(place, {});
    EXPECT_TRUE(painter.shows(finding, painter.close_up(finding, kAspect).value()));
    EXPECT_TRUE(painter.shows(finding, painter.whole(finding, kAspect)));
  }
}

TEST(FaultPainter, SeesIntoARoomFromOutside) {
  const scene::Scene scene = tests::box_scene(Facing::Inward);
  const Finding finding = fault_at({2, 1, 0}, {0});
  const FaultPainter through(scene, BackFaces::SeenThrough), solid(scene, BackFaces::Seen);
  EXPECT_TRUE(through.shows(finding, through.close_up(finding, kAspect).value()));
  EXPECT_FALSE(solid.shows(finding, {.position = {2, 1, 9}, .target = {2, 1, 0}, .up = {0, 1, 0}}));
}

TEST(FaultPainter, WithoutAPlace_HasNoCloseUp) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  Finding finding;
  EXPECT_FALSE(FaultPainter(scene).close_up(finding, kAspect));
}

TEST(FaultPainter, SamePictureOnAnyNumberOfThreads) {
  const scene::Scene scene = tests::box_scene(Facing::Outward);
  const FaultPainter painter(scene);
  const Finding finding = fault_at({1, 1, 2}, {1});
  const DrawnFault fault = drawn(finding);
  const FaultPicture view = small(painter.whole(finding, kAspect));
  const Image many = painter.picture(view, {&fault, 1});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(painter.picture(view, {&fault, 1}).pixels, many.pixels);
}

}  // namespace
}  // namespace rad::bake
