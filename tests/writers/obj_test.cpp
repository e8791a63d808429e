#include "writers/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include "readers/reader.h"
#include "scene/scene_builder.h"
#include "tests/writers/written_files.h"
#include "writers/bridged_ring.h"

namespace rad::writers {
namespace {

using scene::Scene;
using scene::SceneBuilder;
using scene::VertexId;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::bytes_of;
using tests::fresh_folder;

SceneBuilder two_triangles() {
  SceneBuilder builder("pair.obj", "obj");
  builder.add_vertex({0.1, -0.0, 1e-7});
  builder.add_vertex({1.0 / 3, 2e300, -5e-324});
  builder.add_vertex({12345.678901234567, 0, 1});
  builder.add_vertex({7, 8, 9});
  scene::Material& red = builder.material_at(builder.material("red paint"));
  red.reflectance = {0.7, 0.1, 0.05};
  red.reflectance_stated = true;
  scene::Material& glow = builder.material_at(builder.material("glow"));
  glow.emission = {1.5, 2, 2.5};
  builder.add_face(std::array<VertexId, 3>{0, 1, 2}, 0);
  builder.use_object(builder.object("a thing"));
  builder.use_group(builder.group("part 1"));
  builder.use_material(builder.material("red paint"));
  builder.add_face(std::array<VertexId, 4>{0, 1, 2, 3}, 1);
  builder.use_material(builder.material("glow"));
  builder.add_face(std::array<VertexId, 3>{2, 1, 3}, 2);
  return builder;
}

// Everything that OBJ can hold, face by face, with names in place of ids.
std::string content(const Scene& scene) {
  std::string text;
  for (const geom::dvec3& p : scene.vertices) {
    for (const double c : {p.x, p.y, p.z}) text += std::to_string(std::bit_cast<std::uint64_t>(c)) + " ";
  }
  for (const scene::Face& face : scene.faces) {
    const scene::Material& material = scene.materials[face.material];
    text += "\n" + scene.objects[face.object] + "|" + scene.groups[face.group] + "|" + material.name + "|";
    for (const geom::dvec3& colour : {material.reflectance, material.emission}) {
      for (const double c : {colour.x, colour.y, colour.z}) text += std::to_string(c) + " ";
    }
    for (const scene::Loop& loop : scene.loops_of(face)) {
      text += "|";
      for (const VertexId id : scene.corners_of(loop)) text += std::to_string(id) + " ";
    }
  }
  return text;
}

TEST(ObjText, KeepsNamesNumbersAndOrder) {
  const std::array<std::string, 1> comments{"written by a test"};
  const ObjText text = obj_text(two_triangles().take(), "pair.mtl", comments);
  EXPECT_EQ(text.obj,
            "# written by a test\n"
            "mtllib pair.mtl\n"
            "v 0.1 -0 1e-07\n"
            "v 0.3333333333333333 2e+300 -5e-324\n"
            "v 12345.678901234567 0 1\n"
            "v 7 8 9\n"
            "f 1 2 3\n"
            "o a thing\n"
            "g part 1\n"
            "usemtl red paint\n"
            "f 1 2 3 4\n"
            "usemtl glow\n"
            "f 3 2 4\n");
  EXPECT_EQ(text.mtl, "newmtl red paint\nKd 0.7 0.1 0.05\nnewmtl glow\nKe 1.5 2 2.5\n");
}

TEST(ObjText, HasNoMtlWithoutMaterials) {
  SceneBuilder builder("plain.obj", "obj");
  for (int i = 0; i < 3; ++i) builder.add_vertex({i * 1.0, i * i * 1.0, 0});
  builder.add_face(std::array<VertexId, 3>{0, 1, 2}, 0);
  const ObjText text = obj_text(builder.take(), "plain.mtl");
  EXPECT_EQ(text.mtl, "");
  EXPECT_THAT(text.obj, Not(HasSubstr("mtl")));
}

TEST(ObjText, NamesTheUnnamedMaterialWhereItFollowsAnother) {
  SceneBuilder builder = two_triangles();
  builder.use_material(0);
  builder.add_face(std::array<VertexId, 3>{0, 2, 3}, 3);
  const ObjText text = obj_text(builder.take(), "pair.mtl");
  EXPECT_THAT(text.obj, HasSubstr("usemtl unnamed\nf 1 2 3\n"));
  EXPECT_THAT(text.obj, HasSubstr("usemtl unnamed\nf 1 3 4\n"));
  EXPECT_THAT(text.mtl, HasSubstr("newmtl unnamed\n"));
}

TEST(ObjText, TurnsLuminanceIntoExitance) {
  SceneBuilder builder = two_triangles();
  scene::Material& glow = builder.material_at(builder.material("glow"));
  glow.emission_unit = scene::Material::EmissionUnit::Luminance;
  glow.emission = {1, 0, 0};
  EXPECT_THAT(obj_text(builder.take(), "pair.mtl").mtl, HasSubstr("Ke 3.141592653589793 0 0\n"));
}

TEST(ObjText, KeepsNamesOnTheirLine) {
  SceneBuilder builder = two_triangles();
  builder.use_object(builder.object("bad\nname\\"));
  builder.add_face(std::array<VertexId, 3>{0, 2, 3}, 3);
  EXPECT_THAT(obj_text(builder.take(), "pair.mtl").obj, HasSubstr("o bad_name_\n"));
}

TEST(WriteObj, ReadsBackTheSame) {
  const auto path = fresh_folder("round_trip") / "pair.obj";
  const Scene scene = two_triangles().take();
  ASSERT_EQ(write_obj({scene}, path).problem, "");
  const readers::ReadResult read = readers::read_file(path);
  EXPECT_TRUE(read.issues.all().empty());
  EXPECT_EQ(content(read.scene), content(scene));
}

TEST(WriteObj, ReadsBackRandomPolygonSoup) {
  const auto path = fresh_folder("soup") / "soup.obj";
  std::mt19937_64 random(7);
  SceneBuilder builder("soup.obj", "obj");
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() % 2000003) - 1000001, -17); };
  for (int i = 0; i < 200; ++i) builder.add_vertex({coordinate(), coordinate(), coordinate()});
  for (int i = 0; i < 300; ++i) {
    builder.use_object(builder.object("object " + std::to_string(random() % 5)));
    builder.use_group(builder.group("group" + std::to_string(random() % 3)));
    builder.use_material(builder.material("m" + std::to_string(random() % 4)));
    std::vector<VertexId> ring(3 + random() % 6);
    for (VertexId& id : ring) id = static_cast<VertexId>(random() % 200);
    builder.add_face(ring, static_cast<std::uint64_t>(i));
  }
  const Scene scene = builder.take();
  ASSERT_EQ(write_obj({scene}, path).problem, "");
  EXPECT_EQ(content(readers::read_file(path).scene), content(scene));
}

TEST(WriteObj, SaysWhyItCannotWriteAndLeavesNothing) {
  const auto folder = fresh_folder("unwritable");
  const auto path = folder / "no such folder" / "pair.obj";
  EXPECT_THAT(write_obj({two_triangles().take()}, path).problem, HasSubstr("cannot be opened for writing"));
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(WriteObj, ReplacesAndLeavesNoPartialFile) {
  const auto folder = fresh_folder("replace");
  std::ofstream(folder / "pair.obj") << "old";
  ASSERT_TRUE(write_obj({two_triangles().take()}, folder / "pair.obj").ok());
  EXPECT_THAT(bytes_of(folder / "pair.obj"), HasSubstr("mtllib pair.mtl"));
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  EXPECT_THAT(names, ElementsAre("pair.mtl", "pair.obj"));
}

// A plate in the plane z = slope·x with square holes at these places.
Scene plate(const std::vector<std::array<double, 2>>& holes, double slope, bool holes_turned = false) {
  SceneBuilder builder("plate.obj", "obj");
  const auto ring = [&](double u, double v, double size, bool turned) {
    std::vector<VertexId> ids;
    for (const auto& [a, b] : std::array<std::array<double, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
      ids.push_back(builder.add_vertex({u + a * size, v + b * size, slope * (u + a * size)}));
    }
    if (turned) std::reverse(ids.begin(), ids.end());
    return ids;
  };
  builder.add_face(ring(0, 0, 10, false), 0);
  for (const auto& [u, v] : holes) builder.add_hole(ring(u, v, 1, !holes_turned));
  return builder.take();
}

geom::dvec3 area_vector(const Scene& scene, const std::vector<VertexId>& ring) {
  geom::dvec3 sum{0, 0, 0};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geom::dvec3 &a = scene.vertices[ring[i]], &b = scene.vertices[ring[(i + 1) % ring.size()]];
    sum += geom::dvec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x) * 0.5;
  }
  return sum;
}

bool edges_cross(const Scene& scene, const std::vector<VertexId>& ring) {
  const auto turn = [&](VertexId a, VertexId b, VertexId c) {
    const auto &p = scene.vertices[a], &q = scene.vertices[b], &r = scene.vertices[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const VertexId a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[j], d = ring[(j + 1) % ring.size()];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
  }
  return false;
}

std::vector<VertexId> ring_of_vertices(const Scene& scene) {
  std::vector<VertexId> ring;
  for (const std::uint32_t corner : bridged_ring(scene, scene.faces[0])) ring.push_back(scene.corners[corner]);
  return ring;
}

void expect_sound_bridges(const Scene& scene, double area) {
  const std::vector<VertexId> ring = ring_of_vertices(scene);
  EXPECT_EQ(ring.size(), scene.corners.size() + 2 * (scene.faces[0].loop_count - 1));
  EXPECT_EQ(std::set<VertexId>(ring.begin(), ring.end()).size(), scene.vertices.size());
  EXPECT_NEAR(area_vector(scene, ring).z, area, 1e-9);
  EXPECT_FALSE(edges_cross(scene, ring));
}

TEST(BridgedRing, IsTheOuterLoopWithoutHoles) {
  const Scene scene = plate({}, 0);
  EXPECT_THAT(bridged_ring(scene, scene.faces[0]), ElementsAre(0, 1, 2, 3));
}

TEST(BridgedRing, ReachesEveryHole) {
  expect_sound_bridges(plate({{4, 4}}, 0), 99);
  expect_sound_bridges(plate({{4, 4}}, 3), 99);
  expect_sound_bridges(plate({{1, 1}, {3, 1}, {5, 1}, {7, 1}, {1, 5}, {3, 5}, {8.5, 5.25}}, 0.5), 93);
}

TEST(BridgedRing, TurnsHolesThatRunTheWrongWay) { expect_sound_bridges(plate({{2, 2}, {6, 7}}, 1, true), 98); }

TEST(BridgedRing, ReachesManyHolesOnACommonLine) {
  std::vector<std::array<double, 2>> holes;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) holes.push_back({0.5 + 2.5 * i, 0.5 + 2.5 * j});
  }
  expect_sound_bridges(plate(holes, 0), 84);
}

TEST(BridgedRing, KeepsAFaceThatIsNotFinite) {
  Scene scene = plate({{4, 4}}, 0);
  scene.vertices[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(bridged_ring(scene, scene.faces[0]), ElementsAre(0, 1, 2, 3));
}

}  // namespace
}  // namespace rad::writers
