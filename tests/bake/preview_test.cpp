#include "bake/preview.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <limits>

#include "bake/lit_camera.h"
#include "bake/png.h"
#include "tests/bake/drawn_scenes.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using scene::Scene;
using scene::SceneBuilder;
using scene::VertexLight;
using tests::Facing;

/// A triangle in the plane z = 0 that covers the lower left half of the square from -1 to 1, facing the camera at +z,
/// which sees exactly that square.
struct HalfSquare {
  Scene scene;
  VertexLight light;
  PreviewOptions options;

  HalfSquare() {
    SceneBuilder builder("half.obj", "obj");
    tests::add_polygon(builder, {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}});
    scene = builder.take();
    light.colour = {{0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 1}};
    options.width = options.height = 8;
    options.samples_per_axis = 1;
    options.camera =
        Camera{.position = {0, 0, 1}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_field_of_view_deg = 90};
    options.background = {0.125, 0.25, 0.5};
  }
};

void expect_near(const dvec3& actual, const dvec3& expected) {
  // Barycentric coordinates come in single precision.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-5);
}

TEST(Render, WithLight_InterpolatesBetweenTheVertices) {
  const HalfSquare half;
  const Image image = render(half.scene, &half.light, half.options);
  ASSERT_EQ(image.pixels.size(), 64u);
  // The centre of pixel (x, y) lies (x + 1/2) / 8 along the lower side and (7 - y + 1/2) / 8 up the left one.
  const auto expected = [&](double u, double v) {
    return (1 - u - v) * half.light.colour[0] + u * half.light.colour[1] + v * half.light.colour[2];
  };
  expect_near(image.at(0, 7), expected(0.5 / 8, 0.5 / 8));
  expect_near(image.at(5, 7), expected(5.5 / 8, 0.5 / 8));
  expect_near(image.at(2, 4), expected(2.5 / 8, 3.5 / 8));
  EXPECT_EQ(image.at(7, 0), half.options.background);
  EXPECT_EQ(image.at(5, 3), half.options.background);
}

TEST(Render, Samples_BlendTheBorder) {
  HalfSquare half;
  half.light.colour.assign(3, {1, 1, 1});
  half.options.background = {0, 0, 0};
  half.options.samples_per_axis = 4;
  const Image image = render(half.scene, &half.light, half.options);
  EXPECT_EQ(image.at(0, 7), dvec3(1, 1, 1));
  // Six of the sixteen samples lie below the diagonal of the pixel, four on it and six above.
  EXPECT_GE(image.at(4, 4).x, 6.0 / 16);
  EXPECT_LE(image.at(4, 4).x, 10.0 / 16);
  EXPECT_EQ(image.at(5, 4), dvec3(0, 0, 0));
}

TEST(Render, BackFaces_SeenThroughOrMarked) {
  HalfSquare half;
  half.options.camera->position = {0, 0, -1};
  EXPECT_EQ(render(half.scene, &half.light, half.options).at(7, 7), half.options.background);
  half.options.cull_back_faces = false;
  EXPECT_EQ(render(half.scene, &half.light, half.options).at(7, 7), dvec3(0, 0, 0));
  const dvec3 back = render(half.scene, nullptr, half.options).at(7, 7);
  EXPECT_GT(back.x, 2 * back.z) << "backs are told from fronts";
}

TEST(Render, WithoutLight_BrighterHeadOn) {
  HalfSquare half;
  const dvec3 head_on = render(half.scene, nullptr, half.options).at(3, 4);
  EXPECT_EQ(head_on.x, head_on.z) << "neutral";
  half.options.camera->position = {0, 0.9, 0.1};
  half.options.camera->target = {0, 0, 0};
  EXPECT_LT(render(half.scene, nullptr, half.options).at(3, 4).x, head_on.x - 0.2);
}

TEST(Render, NearestFaceHides_TheOneBehind) {
  HalfSquare half;
  SceneBuilder builder("two.obj", "obj");
  tests::add_polygon(builder, {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}});
  tests::add_polygon(builder, {{-0.5, -0.5, 0.5}, {0, -0.5, 0.5}, {-0.5, 0, 0.5}});
  half.light.colour.assign(3, {1, 0, 0});
  half.light.colour.resize(6, {0, 1, 0});
  const Image image = render(builder.scene(), &half.light, half.options);
  expect_near(image.at(0, 7), {0, 1, 0});
  expect_near(image.at(6, 7), {1, 0, 0});
}

TEST(Render, Outlines_OnEdgesOfFacesAndNotOnDiagonals) {
  SceneBuilder builder("square.obj", "obj");
  tests::add_polygon(builder, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  PreviewOptions options;
  options.width = options.height = 40;
  options.camera =
      Camera{.position = {0, 0, 2}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_field_of_view_deg = 90};
  const Image plain = render(builder.scene(), nullptr, options);
  options.outline_faces = true;
  const Image outlined = render(builder.scene(), nullptr, options);
  EXPECT_EQ(outlined.at(20, 20), plain.at(20, 20));
  EXPECT_EQ(outlined.at(25, 25), plain.at(25, 25));
  EXPECT_LT(outlined.at(20, 10).x, plain.at(20, 10).x / 2) << "the upper side";
  expect_near(outlined.at(20, 5), options.background);
}

TEST(Render, RoomFromOutside_IsSeenInto) {
  const Scene room = tests::box_scene(Facing::Inward);
  PreviewOptions options;
  options.width = 64;
  options.height = 48;
  const Image image = render(room, nullptr, options);
  // Three sides are seen, so at least three shades beside the background.
  std::vector<std::uint8_t> shades;
  for (const dvec3& pixel : image.pixels) shades.push_back(srgb_code(pixel.x));
  std::sort(shades.begin(), shades.end());
  shades.erase(std::unique(shades.begin(), shades.end()), shades.end());
  EXPECT_GE(shades.size(), 4u);
  EXPECT_NE(image.at(32, 24), options.background);
}

/// A lit room inside a dark shell.
struct Building {
  Scene scene;
  VertexLight light;

  Building() {
    SceneBuilder builder("building.obj", "obj");
    builder.scene().up = scene::UpAxis::Z;
    tests::add_box(builder, {-0.2, -0.2, -0.2}, {4.2, 3.2, 2.2}, Facing::Outward);
    light.colour.assign(builder.vertex_count(), {0, 0, 0});
    tests::add_box(builder, {0, 0, 0}, {4, 3, 2}, Facing::Inward);
    light.colour.resize(builder.vertex_count(), {0.5, 0.5, 0.5});
    scene = builder.take();
  }
};

TEST(Render, DarkBuilding_IsShownFromInside) {
  const Building building;
  PreviewOptions options;
  options.width = 64;
  options.height = 48;
  const Image image = render(building.scene, &building.light, options);
  for (const dvec3& pixel : image.pixels) expect_near(pixel, {0.5, 0.5, 0.5});
}

TEST(LitCamera, LitOutside_StaysOutside) {
  Building building;
  building.light.colour.assign(building.light.colour.size(), {0.5, 0.5, 0.5});
  const auto triangles = drawn_triangles(building.scene);
  const RayScene shown(building.scene, triangles, BackFaces::SeenThrough);
  const Camera camera = lit_camera(building.scene, building.light, triangles, shown, 1);
  EXPECT_EQ(camera.position, automatic_camera(building.scene, 1).position);
}

TEST(LitCamera, AllDark_StaysOutside) {
  Building building;
  building.light.colour.assign(building.light.colour.size(), {0, 0, 0});
  const auto triangles = drawn_triangles(building.scene);
  const RayScene shown(building.scene, triangles, BackFaces::SeenThrough);
  const Camera camera = lit_camera(building.scene, building.light, triangles, shown, 1);
  EXPECT_EQ(camera.position, automatic_camera(building.scene, 1).position);
}

std::string bytes_with_threads(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  SceneBuilder builder("boxes.obj", "obj");
  // Coincident sides: which of two is met must not hang on the threads.
  for (int i = 0; i < 12; ++i) tests::add_box(builder, {i, 0, 0}, {i + 2, 2, 2}, Facing::Outward);
  VertexLight light;
  for (std::size_t i = 0; i < builder.vertex_count(); ++i) {
    light.colour.push_back(dvec3{(i * 37) % 101, (i * 53) % 101, (i * 71) % 101} / 101.0);
  }
  PreviewOptions options;
  options.width = 120;
  options.height = 90;
  options.outline_faces = true;
  return png_bytes(render(builder.scene(), &light, options));
}

TEST(Render, OneThreadOrTwo_SameBytes) {
  const std::string one = bytes_with_threads(1);
  EXPECT_EQ(one, bytes_with_threads(2));
  EXPECT_EQ(one, bytes_with_threads(2));
}

TEST(Render, NothingToSeeOrNowhereToStand_OnlyBackground) {
  const HalfSquare half;
  PreviewOptions options = half.options;
  options.camera->position = options.camera->target;
  for (const dvec3& pixel : render(half.scene, nullptr, options).pixels) EXPECT_EQ(pixel, options.background);
  options.camera.reset();
  const Scene empty = scene::empty_scene("none.obj", "obj");
  for (const dvec3& pixel : render(empty, nullptr, options).pixels) EXPECT_EQ(pixel, options.background);
  options.width = 0;
  EXPECT_TRUE(render(half.scene, nullptr, options).pixels.empty());
}

TEST(Render, HugeAndTinyScenes_AreDrawnAlike) {
  const HalfSquare half;
  const Image expected = render(half.scene, nullptr, half.options);
  for (const double scale : {1e-9, 1e9, 1e30}) {
    HalfSquare scaled;
    for (dvec3& vertex : scaled.scene.vertices) vertex *= scale;
    scaled.options.camera->position *= scale;
    const Image image = render(scaled.scene, nullptr, scaled.options);
    expect_near(image.at(2, 5), expected.at(2, 5));
  }
}

}  // namespace
}  // namespace rad::bake
