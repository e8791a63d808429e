// Radiance scenes, DXF, CityJSON and 3MF: what is written is read back by readers that share no code with the writers.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "readers/components.h"
#include "scene/drawing_colour.h"
#include "scene/index_colour.h"
#include "tests/writers/written_files.h"
#include "writers/bridged_ring.h"
#include "writers/zip.h"

namespace rad::writers {
namespace {

using namespace tests;
using scene::Scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene read_back(const std::filesystem::path& path) {
  readers::ReadResult result = readers::read_file(path);
  EXPECT_TRUE(result.issues.all().empty()) << path << ": " << result.issues.all().front().what;
  return std::move(result.scene);
}

std::string shown(const std::string& name) { return name.empty() ? "unnamed" : name; }

/// "object|material|" and the exact places of the ring over bridges, face by face, in ascending order.
std::vector<std::string> rings_of(const Scene& scene) {
  std::vector<std::string> rings;
  for (const scene::Face& face : scene.faces) {
    std::string& ring =
        rings.emplace_back(shown(scene.objects[face.object]) + "|" + shown(scene.materials[face.material].name) + "|");
    for (const std::uint32_t corner : bridged_ring(scene, face))
      ring += bits_of(scene.vertices[scene.corners[corner]]) + " ";
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

/// A square with a square hole, in one object and material.
Scene frame() {
  scene::SceneBuilder builder("frame.obj", "obj");
  builder.use_object(builder.object("frame"));
  builder.use_group(builder.group("WallSurface"));
  builder.use_material(builder.material("wood"));
  for (const geom::dvec3& p :
       {geom::dvec3{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}, {1, 0, 1}, {1, 0, 3}, {3, 0, 3}, {3, 0, 1}}) {
    builder.add_vertex(p);
  }
  builder.add_face(std::vector<scene::VertexId>{0, 1, 2, 3}, 0);
  builder.add_hole(std::vector<scene::VertexId>{4, 5, 6, 7});
  return builder.take();
}

TEST(RadWriter, KeepsPolygonsNamesAndReflectance) {
  const auto path = fresh_folder("rad") / "model.rad";
  for (const Scene& scene : corpus_scenes()) {
    const scene::RecordedLattice lattice = lattice_of(scene);
    ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
    const Scene read = read_back(path);
    EXPECT_EQ(rings_of(read), rings_of(scene));
    ASSERT_TRUE(read.recorded);
    EXPECT_EQ(read.recorded->tolerance, lattice.tolerance);
    EXPECT_EQ(read.recorded->lattice.pitch, lattice.lattice.pitch);
  }
}

TEST(RadWriter, LightsHaveRadianceAndNamesAreQuoted) {
  const auto path = fresh_folder("rad_light") / "model.rad";
  Scene scene = two_plates();
  scene.materials[2].name = "a 'big' lamp";
  scene.objects[1] = "#left";
  ASSERT_EQ(write({scene}, path), "");
  const std::string text = bytes_of(path);
  EXPECT_THAT(text, HasSubstr("void light \"a 'big' lamp\"\n0\n0\n3 9.5492"));
  EXPECT_THAT(text, HasSubstr("void plastic wall\n0\n0\n5 0.7 0.25 0.1 0 0\n"));
  EXPECT_THAT(text, HasSubstr("wall polygon \"#left.1\"\n0\n0\n12\n 0 0 0\n 1 0 0\n"));
  const Scene read = read_back(path);
  EXPECT_EQ(rings_of(read), rings_of(scene));
  const auto lamp = std::ranges::find(read.materials, "a 'big' lamp", &scene::Material::name);
  ASSERT_NE(lamp, read.materials.end());
  EXPECT_NEAR(lamp->emission.x, 30, 1e-12);
  scene.materials[2].emission_unit = scene::Material::EmissionUnit::Luminance;
  ASSERT_EQ(write({scene}, path), "");
  EXPECT_NEAR(read_back(path).materials[2].emission.x, 30 / 179.0 * std::numbers::pi, 1e-12);
}

TEST(RadWriter, HolesAreReachedOverSeams) {
  const auto path = fresh_folder("rad_hole") / "model.rad";
  ASSERT_EQ(write({frame()}, path), "");
  EXPECT_EQ(read_back(path).corners.size(), 10u);
}

TEST(DxfWriter, KeepsQuadsTrianglesLayersAndUnit) {
  const auto path = fresh_folder("dxf") / "model.dxf";
  for (Scene scene : corpus_scenes()) {
    scene = small_faces_of(std::move(scene));
    scene.metres_per_unit = 0.01;
    const scene::RecordedLattice lattice = lattice_of(scene);
    ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
    const Scene read = read_back(path);
    EXPECT_EQ(polygons_of(read), polygons_of(scene));
    EXPECT_EQ(read.metres_per_unit, 0.01);
    ASSERT_TRUE(read.recorded);
    EXPECT_EQ(bits_of(read.recorded->lattice.origin), bits_of(lattice.lattice.origin));
    for (std::size_t i = 0; i < scene.faces.size(); ++i) {
      const std::string& object = scene.objects[scene.faces[i].object];
      EXPECT_EQ(read.objects[read.faces[i].object], object.empty() ? "0" : object);
    }
  }
}

TEST(DxfWriter, ColoursAreTheNearestOfTheIndex) {
  const auto path = fresh_folder("dxf_colour") / "model.dxf";
  Scene scene = two_plates();
  scene.materials[1].reflectance = scene::reflectance_of_colour(0xFE0301);
  ASSERT_EQ(write({scene}, path), "");
  const Scene read = read_back(path);
  EXPECT_EQ(read.materials[read.faces[0].material].reflectance, scene::reflectance_of_colour(0xFF0000));
  EXPECT_EQ(scene::nearest_index(0x0000FF), 5);
  EXPECT_EQ(scene::nearest_index(0x808080), 8);
}

TEST(DxfWriter, RefusesFacesThatMustBeDividedFirst) {
  const auto path = fresh_folder("dxf_hole") / "model.dxf";
  EXPECT_THAT(write({frame()}, path), HasSubstr("face 0"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(CityJsonWriter, KeepsEverythingOnTheLattice) {
  const auto path = fresh_folder("city") / "model.city.json";
  for (Scene scene : corpus_scenes()) {
    const scene::RecordedLattice lattice = lattice_of(scene);
    snap(scene, lattice.lattice);
    ASSERT_EQ(write({.scene = scene, .lattice = lattice}, path), "");
    const Scene read = read_back(path);
    ASSERT_EQ(read.vertices.size(), scene.vertices.size());
    for (std::size_t i = 0; i < scene.vertices.size(); ++i)
      EXPECT_EQ(bits_of(read.vertices[i]), bits_of(scene.vertices[i]));
    ASSERT_TRUE(read.recorded);
    EXPECT_EQ(read.recorded->lattice.pitch, lattice.lattice.pitch);
  }
}

TEST(CityJsonWriter, KeepsHolesSemanticsAndMaterials) {
  const auto path = fresh_folder("city_hole") / "model.city.json";
  Scene scene = frame();
  scene.materials[1].reflectance = {0.3, 0.2, 0.1};
  scene.materials[1].reflectance_stated = true;
  ASSERT_EQ(write({scene}, path), "");
  const Scene read = read_back(path);
  EXPECT_EQ(polygons_of(read), polygons_of(scene));
  const scene::Face& face = read.faces.at(0);
  EXPECT_EQ(face.loop_count, 2u);
  EXPECT_EQ(read.groups[face.group], "WallSurface");
  EXPECT_EQ(read.objects[face.object], "frame");
  EXPECT_EQ(read.materials[face.material].name, "wood");
  EXPECT_NEAR(read.materials[face.material].reflectance.x, 0.3, 1e-12);
}

TEST(CityJsonWriter, IsInMetresWithZUp) {
  const auto path = fresh_folder("city_unit") / "model.city.json";
  Scene scene = frame();
  scene.metres_per_unit = 0.25;
  scene.up = scene::UpAxis::Y;
  ASSERT_EQ(write({scene}, path), "");
  const Scene read = read_back(path);
  EXPECT_EQ(read.vertices[2], geom::dvec3(1, -1, 0));
  EXPECT_FALSE(read.recorded);
}

TEST(Zip, HasHeadersThatAgree) {
  const std::string archive = zip_of(std::array<ZipEntry, 2>{{{"a.txt", "123456789"}, {"d/b", ""}}});
  EXPECT_EQ(archive.substr(0, 4), "PK\x03\x04");
  // The check value of CRC-32.
  EXPECT_EQ(archive.substr(14, 4), "\x26\x39\xF4\xCB");
  EXPECT_EQ(archive.substr(30, 14), "a.txt123456789");
  EXPECT_EQ(archive.substr(archive.size() - 22, 4), "PK\x05\x06");
  EXPECT_EQ(archive[archive.size() - 12], 2);
}

TEST(ThreeMfWriter, WritesObjectsWithBaseMaterials) {
  const auto path = fresh_folder("3mf") / "model.3mf";
  Scene scene = two_plates();
  scene.metres_per_unit = 0.001;
  scene.materials[1].reflectance = scene::reflectance_of_colour(0x123456);
  scene.objects[1] = "a & <b>";
  ASSERT_EQ(write({scene}, path), "");
  const std::string bytes = bytes_of(path);
  EXPECT_THAT(bytes, HasSubstr("<model unit=\"millimeter\""));
  EXPECT_THAT(bytes, HasSubstr("<base name=\"wall\" displaycolor=\"#123456\"/>"));
  EXPECT_THAT(bytes, HasSubstr("name=\"a &amp; &lt;b>\">"));
  EXPECT_THAT(bytes, HasSubstr("<triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"1\" p1=\"2\"/>"));
  EXPECT_THAT(bytes, HasSubstr("<item objectid=\"3\"/>"));
  if (readers::missing_component("a.3mf") != nullptr) GTEST_SKIP() << "this build does not read 3MF";
  const readers::ReadResult read = readers::read_file(path);
  EXPECT_EQ(read.scene.faces.size(), 4u) << read.issues.all().front().what;
}

TEST(Holds, NamesWhatASceneLoses) {
  Scene scene = two_plates();
  scene.metres_per_unit = 1;
  const auto stl = losses_of(scene, writer_for("a.stl")->holds);
  EXPECT_THAT(stl, ElementsAre("1 face is divided into triangles", "coordinates beyond single precision", "the unit",
                               "2 names of objects", "2 names of materials", "2 reflectances", "1 emission of light"));
  EXPECT_THAT(losses_of(scene, writer_for("a.obj")->holds), ElementsAre("the unit"));
  EXPECT_THAT(losses_of(scene, writer_for("a.rad")->holds), ElementsAre("the unit", "1 reflectance of a light"));
  EXPECT_THAT(losses_of(frame(), writer_for("a.rad")->holds),
              ElementsAre("1 face has holes, reached over a seam", "1 name of a group"));
  EXPECT_TRUE(losses_of(scene, writer_for("a.stage.json")->holds).empty());
}

}  // namespace
}  // namespace rad::writers
