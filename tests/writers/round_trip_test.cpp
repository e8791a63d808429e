// What is written is read back the same, in every format, but for what the format has no place for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_scenes.h"
#include "tests/writers/written_files.h"

namespace rad::writers {
namespace {

using namespace tests;
using scene::Scene;
using ::testing::HasSubstr;

constexpr std::array<const char*, 3> kPolygonFormats = {"obj", "ply", "off"};
constexpr std::array<const char*, 6> kAllFormats = {"obj", "ply", "stl", "off", "glb", "gltf"};

std::vector<Scene> random_scenes() {
  std::vector<Scene> scenes;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomScene random(seed);
    for (int i = 0; i < 5; ++i) {
      random.add_box();
      random.add_sheet();
      random.add_triangle();
      random.add_tilted_sheet();
    }
    scenes.push_back(random.take());
  }
  return scenes;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all = corpus_scenes();
  std::ranges::move(random_scenes(), std::back_inserter(all));
  return all;
}

Scene read_back(const std::filesystem::path& path) {
  readers::ReadResult result = readers::read_file(path);
  EXPECT_TRUE(result.issues.all().empty()) << path << ": " << result.issues.all().front().what;
  return std::move(result.scene);
}

// Through memory: GCC 12 drops a conversion to float and back when it vectorises a loop.
geom::dvec3 in_single_precision(geom::dvec3 v) {
  for (int axis = 0; axis < 3; ++axis) {
    volatile float stored = static_cast<float>(v[axis]);
    v[axis] = stored;
  }
  return v;
}

void expect_record(const Scene& scene, const scene::RecordedLattice& lattice) {
  ASSERT_TRUE(scene.recorded);
  EXPECT_EQ(scene.recorded->tolerance, lattice.tolerance);
  EXPECT_EQ(scene.recorded->lattice.pitch, lattice.lattice.pitch);
  EXPECT_EQ(bits_of(scene.recorded->lattice.origin), bits_of(lattice.lattice.origin));
}

TEST(RoundTrip, KeepsPolygonsAndTheLattice) {
  const auto folder = fresh_folder("polygons");
  for (const Scene& scene : scenes()) {
    const scene::RecordedLattice lattice = lattice_of(scene);
    for (const char* format : kPolygonFormats) {
      const auto path = folder / (std::string("model.") + format);
      ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
      const Scene read = read_back(path);
      ASSERT_EQ(read.vertices.size(), scene.vertices.size());
      for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        ASSERT_EQ(bits_of(read.vertices[i]), bits_of(scene.vertices[i])) << format;
      }
      EXPECT_EQ(polygons_of(read), polygons_of(scene)) << format;
      expect_record(read, lattice);
    }
  }
}

// Shifts bring an origin that is not zero and coordinates that single precision cannot hold.
TEST(RoundTrip, KeepsTrianglesOfGltfToTheLastBit) {
  const auto folder = fresh_folder("triangles");
  for (Scene scene : scenes()) {
    scene = small_faces_of(std::move(scene));
    for (const double shift : {0.0, 54321.987, -1e7}) {
      for (geom::dvec3& vertex : scene.vertices) vertex += geom::dvec3(shift, shift / 3, 0);
      const scene::RecordedLattice lattice = lattice_of(scene);
      snap(scene, lattice.lattice);
      scene = small_faces_of(std::move(scene));
      for (const char* format : {"glb", "gltf"}) {
        const auto path = folder / (std::string("model.") + format);
        ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
        const Scene read = read_back(path);
        EXPECT_EQ(facets_of(read, true), facets_of(scene, true)) << format << " " << shift;
        expect_record(read, lattice);
      }
    }
  }
}

TEST(RoundTrip, KeepsTheTrianglesOfStlInSinglePrecision) {
  const auto path = fresh_folder("stl") / "model.stl";
  for (Scene scene : scenes()) {
    for (geom::dvec3& vertex : scene.vertices) vertex = in_single_precision(vertex);
    scene = small_faces_of(std::move(scene));
    ASSERT_EQ(write({scene}, path), "");
    EXPECT_EQ(facets_of(read_back(path), false), facets_of(scene, false));
  }
}

TEST(RoundTrip, OfFloatsThroughGltfNeedsNoLattice) {
  const auto path = fresh_folder("floats") / "model.glb";
  Scene scene = two_plates();
  for (geom::dvec3& vertex : scene.vertices) vertex = in_single_precision(vertex * (1.0 / 3) + 0.1);
  ASSERT_EQ(write({scene}, path), "");
  const Scene read = read_back(path);
  EXPECT_EQ(facets_of(read, true), facets_of(scene, true));
  EXPECT_FALSE(read.recorded);
}

TEST(RoundTrip, OfDoublesWithoutALatticeLosesHalfAFloatOfTheExtent) {
  const auto path = fresh_folder("doubles") / "model.glb";
  const Scene scene = two_plates({1e6 / 3, -2e6 / 3, 0.1});
  ASSERT_EQ(write({scene}, path), "");
  const geom::dvec3 first = read_back(path).vertices.at(0);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(first[axis], scene.vertices[0][axis], 0x1p-23);
}

TEST(RoundTrip, GivesTheSameBytesTwice) {
  const auto folder = fresh_folder("twice");
  const Scene scene = small_faces_of(corpus_scenes().front());
  const scene::VertexLight light = light_on(scene);
  for (const char* format : kAllFormats) {
    const auto path = folder / (std::string("model.") + format);
    ASSERT_EQ(write({.scene = scene, .light = &light, .lattice = lattice_of(scene)}, path), "");
    const std::string first = bytes_of(path);
    ASSERT_EQ(write({.scene = scene, .light = &light, .lattice = lattice_of(scene)}, path), "");
    EXPECT_EQ(bytes_of(path), first) << format;
    EXPECT_THAT(first, testing::Not(HasSubstr(folder.string())));
  }
}

TEST(RoundTrip, RefusesAnEmptySceneAndLightThatDoesNotFit) {
  const auto folder = fresh_folder("empty");
  const Scene empty = scene::empty_scene("", "obj");
  const Scene plates = two_plates();
  scene::VertexLight light = light_on(plates);
  light.colour.pop_back();
  scene::VertexLight broken = light_on(plates);
  broken.radiosity[2].y = std::nan("");
  for (const char* format : kAllFormats) {
    const auto path = folder / (std::string("model.") + format);
    EXPECT_EQ(write({empty}, path), "there is no face to write");
    EXPECT_EQ(write({plates, &light}, path), "the light does not fit the 6 vertices");
    EXPECT_EQ(write({plates, &broken}, path), "the light of a vertex is not finite");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(RoundTrip, FormatsOfTrianglesRefuseLargerFaces) {
  const auto folder = fresh_folder("pentagon");
  scene::SceneBuilder builder("", "obj");
  for (int i = 0; i < 5; ++i) builder.add_vertex({std::cos(1.25 * i), std::sin(1.25 * i), 0});
  builder.add_face(std::vector<scene::VertexId>{0, 1, 2, 3, 4}, 0);
  const Scene pentagon = builder.take();
  for (const char* format : kAllFormats) {
    const auto path = folder / (std::string("model.") + format);
    const std::string problem = write({pentagon}, path);
    EXPECT_EQ(problem.empty(), !writer_for(path)->triangles_only) << format;
    EXPECT_EQ(std::filesystem::exists(path), problem.empty()) << format;
  }
}

TEST(RoundTrip, FloatFormatsRefusePositionsBeyondSinglePrecision) {
  const auto folder = fresh_folder("beyond");
  Scene wide = small_faces_of(two_plates());
  wide.vertices[0].x = -1e39;
  EXPECT_THAT(write({wide}, folder / "model.stl"), HasSubstr("beyond single precision"));
  EXPECT_THAT(write({wide}, folder / "model.glb"), HasSubstr("beyond single precision"));
  wide.vertices[0].x = std::nan("");
  EXPECT_NE(write({wide}, folder / "model.stl"), "");
  EXPECT_NE(write({wide}, folder / "model.gltf"), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace rad::writers
