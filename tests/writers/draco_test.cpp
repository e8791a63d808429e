// Draco twins of GLBs: nothing is lost, whatever is in the scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "geom/lattice.h"
#include "tests/support/lattice_random.h"
#include "tests/writers/written_files.h"
#include "writers/draco_stream.h"
#include "writers/gltf.h"

namespace rad::writers {
namespace {

using namespace tests;
using nlohmann::json;

json document_of(const std::filesystem::path& path) {
  const std::string bytes = bytes_of(path);
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return json::parse(bytes.substr(20, length));
}

/// As facets_of has them, but begun at the same corner whichever the file begins with.
std::vector<std::string> facets_as_rings(scene::Scene scene, bool with_names) {
  for (const scene::Face& face : scene.faces) {
    const scene::Loop& loop = scene.loops_of(face).front();
    const auto ring = std::span(scene.corners).subspan(loop.first, loop.count);
    const auto least = std::min_element(ring.begin(), ring.end(), [&](scene::VertexId a, scene::VertexId b) {
      return bits_of(scene.vertices[a]) < bits_of(scene.vertices[b]);
    });
    std::rotate(ring.begin(), least, ring.end());
  }
  return facets_of(scene, with_names);
}

void expect_same_when_read(const Output& output, const std::string& folder_name) {
  const auto folder = fresh_folder(folder_name);
  ASSERT_EQ(write(output, folder / "plain.glb"), "");
  ASSERT_EQ(write(output, folder / "twin.draco.glb"), "");
  const readers::ReadResult plain = readers::read_file(folder / "plain.glb");
  const readers::ReadResult twin = readers::read_file(folder / "twin.draco.glb");
  EXPECT_TRUE(twin.issues.all().empty()) << twin.issues.all().front().what;
  EXPECT_EQ(facets_as_rings(twin.scene, true), facets_as_rings(plain.scene, true));
}

TEST(DracoTwin, OfModelsOnALatticeDecodesToTheSameFloats) {
  int number = 0;
  for (scene::Scene scene : corpus_scenes()) {
    scene = small_faces_of(std::move(scene));
    const scene::RecordedLattice lattice = lattice_of(scene);
    snap(scene, lattice.lattice);
    expect_same_when_read({.scene = scene, .lattice = lattice}, "draco_lattice_" + std::to_string(number++));
  }
}

TEST(DracoTwin, OfModelsWithoutALatticeKeepsFloatsAsTheyAre) {
  int number = 0;
  for (const scene::Scene& scene : corpus_scenes()) {
    expect_same_when_read({small_faces_of(scene)}, "draco_floats_" + std::to_string(number++));
  }
}

TEST(DracoTwin, FarFromTheOriginLosesNothing) {
  scene::Scene scene = two_plates({4.5e6, -3e5, 120});
  const scene::RecordedLattice lattice = lattice_of(scene);
  snap(scene, lattice.lattice);
  expect_same_when_read({.scene = scene, .lattice = lattice}, "draco_far");
}

TEST(DracoFile, HoldsTheTrianglesOfALatticeAndTheLattice) {
  const auto path = fresh_folder("drc") / "model.drc", plain = fresh_folder("drc_plain") / "model.glb";
  for (const geom::dvec3& shift : {geom::dvec3(0, 0, 0), geom::dvec3(4.5e6, -3e5, 120)}) {
    scene::Scene scene = two_plates(shift);
    const scene::RecordedLattice lattice = lattice_of(scene);
    snap(scene, lattice.lattice);
    ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
    ASSERT_EQ(write({.scene = scene, .lattice = lattice}, plain), "");
    const readers::ReadResult read = readers::read_file(path);
    EXPECT_TRUE(read.issues.all().empty());
    EXPECT_EQ(facets_as_rings(read.scene, false), facets_as_rings(readers::read_file(plain).scene, false));
    ASSERT_TRUE(read.scene.recorded.has_value());
    EXPECT_EQ(read.scene.recorded->tolerance, lattice.tolerance);
    EXPECT_EQ(read.scene.recorded->lattice.pitch, lattice.lattice.pitch);
  }
}

TEST(DracoFile, DamagedIsAParseError) {
  const auto folder = fresh_folder("drc_damaged");
  ASSERT_EQ(write({small_faces_of(corpus_scenes().front())}, folder / "whole.drc"), "");
  const std::string whole = bytes_of(folder / "whole.drc");
  for (const std::size_t size : {std::size_t{5}, std::size_t{12}, whole.size() / 2, whole.size() - 9}) {
    write_bytes(folder / "cut.drc", whole.substr(0, size));
    const readers::ReadResult read = readers::read_file(folder / "cut.drc");
    ASSERT_EQ(read.issues.all().size(), 1U) << size;
    EXPECT_EQ(read.issues.all().front().kind, scene::ReadIssueKind::ParseError);
  }
}

TEST(DracoTwin, CarriesLight) {
  const scene::Scene scene = two_plates();
  const scene::VertexLight light = light_on(scene);
  const auto path = fresh_folder("draco_light") / "lit.draco.glb";
  ASSERT_EQ(write({scene, &light}, path), "");
  const json document = document_of(path);
  for (const json& mesh : document["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      const json& ids = primitive["extensions"]["KHR_draco_mesh_compression"]["attributes"];
      for (const char* name : {"POSITION", "COLOR_0", "_RADIOSITY"}) EXPECT_TRUE(ids.contains(name)) << name;
    }
  }
  EXPECT_EQ(document["extensionsRequired"], json::array({"KHR_draco_mesh_compression"}));
  EXPECT_THAT(document["extensionsUsed"], testing::Contains("KHR_materials_unlit"));
  for (const json& accessor : document["accessors"]) EXPECT_FALSE(accessor.contains("bufferView"));
}

TEST(DracoTwin, IsTheSameFromRunToRun) {
  const scene::Scene scene = small_faces_of(corpus_scenes().front());
  const auto folder = fresh_folder("draco_same");
  ASSERT_EQ(write({scene}, folder / "a.draco.glb"), "");
  ASSERT_EQ(write({scene}, folder / "b.draco.glb"), "");
  EXPECT_EQ(bytes_of(folder / "a.draco.glb"), bytes_of(folder / "b.draco.glb"));
}

/// A wavy sheet of n by n squares on a grid of this step.
struct Sheet {
  std::vector<float> places;
  std::vector<std::uint32_t> corners;

  Sheet(std::uint32_t n, float step, std::uint64_t seed) {
    LatticeRandom random(seed);
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t k = 0; k <= n; ++k) {
        const auto height = static_cast<float>(random.between(0, 40));
        for (const float place : {static_cast<float>(64 * i), static_cast<float>(64 * k), height}) {
          places.push_back(place * step);
        }
      }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
        corners.insert(corners.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    }
  }

  [[nodiscard]] DracoAttribute attribute() const {
    return {.use = DracoUse::Position,
            .bytes = {reinterpret_cast<const char*>(places.data()), places.size() * sizeof(float)}};
  }
};

TEST(DracoStream, OnTheGridIsMuchShorterThanFloats) {
  const Sheet sheet(60, 1.0F / 1024, 1);
  const DracoAttribute attribute = sheet.attribute();
  const DracoGrid grid{{0, 0, 0}, 1.0F / 1024, 13};
  const DracoStream on_grid = draco_stream({&attribute, 1}, sheet.corners, grid);
  const DracoStream floats = draco_stream({&attribute, 1}, sheet.corners, std::nullopt);
  ASSERT_FALSE(on_grid.bytes.empty());
  EXPECT_EQ(on_grid.triangles, 7200U);
  EXPECT_LT(2 * on_grid.bytes.size(), floats.bytes.size());
  EXPECT_LT(4 * on_grid.bytes.size(), sheet.places.size() * sizeof(float));
}

// A grid that the places are not on would move them: the comparison finds it, and floats are stored.
TEST(DracoStream, OffTheGridKeepsFloats) {
  Sheet sheet(8, 1.0F / 1024, 2);
  sheet.places[40] += 1.0F / 4096;
  const DracoAttribute attribute = sheet.attribute();
  const DracoGrid grid{{0, 0, 0}, 1.0F / 1024, 13};
  const DracoStream given = draco_stream({&attribute, 1}, sheet.corners, grid);
  const DracoStream floats = draco_stream({&attribute, 1}, sheet.corners, std::nullopt);
  EXPECT_EQ(given.bytes, floats.bytes);
}

TEST(DracoStream, KeepsEdgesOfManyTrianglesAndDoubles) {
  Sheet sheet(2, 1, 3);
  const std::vector<std::uint32_t> once = sheet.corners;
  sheet.corners.insert(sheet.corners.end(), {0, 1, 5, 0, 1, 6, 1, 0, 7});
  sheet.corners.insert(sheet.corners.end(), once.begin(), once.end());
  const DracoAttribute attribute = sheet.attribute();
  const DracoStream stream = draco_stream({&attribute, 1}, sheet.corners, DracoGrid{{0, 0, 0}, 1, 8});
  ASSERT_FALSE(stream.bytes.empty());
  EXPECT_EQ(stream.triangles, sheet.corners.size() / 3);
}

}  // namespace
}  // namespace rad::writers
