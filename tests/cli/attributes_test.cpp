// Names, texture coordinates and images from file to file, through repair and meshing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/radfix.h"
#include "cli/radlint.h"
#include "readers/reader.h"
#include "run.h"
#include "tests/support/corner_values_text.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using scene::dvec2;
using scene::dvec3;
using scene::Scene;
using testing::HasSubstr;
using testing::Not;

/// A textured box with normals stands on a textured floor, whose outline it lacks (RL211): the floor is cut.
const std::string kRoom =
    "mtllib room.mtl\n"
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n"
    "v 1 1 0\nv 3 1 0\nv 3 3 0\nv 1 3 0\nv 1 1 1\nv 3 1 1\nv 3 3 1\nv 1 3 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.1 0.2\nvt 0.9 0.2\nvt 0.9 0.8\nvt 0.1 0.8\n"
    "vn 0 0 1\nvn 0 0 -1\n"
    "o floor\ng ground\nusemtl oak\ns 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"
    "o box\ng sides\nusemtl paint\ns off\nf 5/5 6/6 10/7 9/8\nf 6/5 7/6 11/7 10/8\nf 7/5 8/6 12/7 11/8\nf 8/5 5/6 9/7 "
    "12/8\n"
    "g ends\nusemtl oak\nf 9/5/1 10/6/1 11/7/1 12/8/1\nf 8/8/2 7/7/2 6/6/2 5/5/2\n";
const std::string kRoomMaterials = "newmtl oak\nKd 0.5 0.4 0.3\nmap_Kd wood/oak.png\nnewmtl paint\nKd 0.7 0.7 0.7\n";

class Attributes : public InFolder {
 protected:
  [[nodiscard]] std::string write_room() const {
    write("room.mtl", kRoomMaterials);
    return write("room.obj", kRoom);
  }
  Scene fixed(const std::string& from, const std::string& to, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> args{from, "-o", at(to)};
    args.insert(args.end(), more.begin(), more.end());
    const Outcome outcome = outcome_of(&run_radfix, args);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    return readers::read_file(at(to)).scene;
  }
};

std::set<std::string> names_of(const Scene& scene) {
  std::set<std::string> names;
  for (const scene::Face& face : scene.faces) {
    names.insert(scene.objects[face.object] + "/" + scene.groups[face.group] + "/" +
                 scene.materials[face.material].name);
  }
  return names;
}

const std::set<std::string> kNames{"floor/ground/oak", "box/sides/paint", "box/ends/oak"};

/// Texture coordinates over the floor are a quarter of the place; those of OBJ count from below.
void expect_floor_mapped(const Scene& scene, bool from_below) {
  std::size_t corners = 0;
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    if (scene.objects[scene.faces[id].object] != "floor") continue;
    const std::vector<dvec2> values = tests::texture_of(scene, id);
    std::size_t i = 0;
    for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
      for (const scene::VertexId vertex : scene.corners_of(loop)) {
        ASSERT_LT(i, values.size());
        const dvec3& place = scene.vertices[vertex];
        EXPECT_NEAR(values[i].x, place.x / 4, 1e-6);
        EXPECT_NEAR(from_below ? values[i].y : 1 - values[i].y, place.y / 4, 1e-6);
        ++i;
        ++corners;
      }
    }
  }
  EXPECT_GE(corners, 4u);
}

TEST_F(Attributes, GoThroughACutFromObjToObj) {
  const Scene scene = fixed(write_room(), "out.obj");
  EXPECT_EQ(names_of(scene), kNames);
  expect_floor_mapped(scene, true);
  EXPECT_THAT(read("out.obj"), HasSubstr("\ns 1\n"));
  EXPECT_THAT(read("out.mtl"), HasSubstr("map_Kd wood/oak.png\n"));
  EXPECT_FALSE(scene.attributes.normals.empty());
}

TEST_F(Attributes, GoFromObjToGlbAndBack) {
  const Scene glb = fixed(write_room(), "out.glb");
  EXPECT_EQ(names_of(glb), kNames);
  expect_floor_mapped(glb, false);
  const Scene back = fixed(at("out.glb"), "back.obj");
  EXPECT_EQ(names_of(back), kNames);
  expect_floor_mapped(back, true);
  ASSERT_TRUE(back.materials.at(1).texture);
  EXPECT_EQ(back.materials[1].texture->image->path, "wood/oak.png");
}

TEST_F(Attributes, StayTheSameInASecondRun) {
  const std::string room = write_room();
  std::filesystem::create_directories(at("one"));
  std::filesystem::create_directories(at("two"));
  for (const auto& [format, more] :
       std::map<std::string, std::vector<std::string>>{{"glb", {}}, {"gltf", {}}, {"obj", {}}, {"ply", {}}}) {
    fixed(room, "one/model." + format, more);
    fixed(at("one/model." + format), "two/model." + format, more);
    EXPECT_TRUE(read("two/model." + format) == read("one/model." + format)) << format;
  }
}

TEST_F(Attributes, AreOnMeshesAndNotOnSolutions) {
  write("lit.mtl", kRoomMaterials + "newmtl lamp\nKd 0.2\nKe 100 90 80\n");
  std::string lit = kRoom + "v 1 1 3\nv 1 3 3\nv 3 3 3\nv 3 1 3\no lamp\ng lamp\nusemtl lamp\nf 13 14 15 16\n";
  lit.replace(lit.find("room.mtl"), 8, "lit.mtl");
  const std::string path = write("lit.obj", lit);
  const std::vector<std::string> coarse{"--patch-size", "1", "--element-size", "0.5"};
  std::vector<std::string> mesh = coarse, solve = coarse;
  mesh.emplace_back("--mesh");
  solve.emplace_back("--solve");
  for (const char* format : {"mesh.glb", "mesh.obj", "mesh.ply"}) {
    const Scene meshed = fixed(path, format, mesh);
    if (std::string(format) != "mesh.ply") expect_floor_mapped(meshed, std::string(format) == "mesh.obj");
    EXPECT_FALSE(meshed.attributes.texture_coordinates.empty()) << format;
  }
  // Triangles then stand in the order of space instead of the order of patches.
  const Scene again = fixed(at("mesh.glb"), "again.glb");
  expect_floor_mapped(again, false);
  EXPECT_EQ(again.faces.size(), readers::read_file(at("mesh.glb")).scene.faces.size());
  fixed(at("again.glb"), "third.glb");
  EXPECT_TRUE(read("third.glb") == read("again.glb"));
  const Scene solved = fixed(path, "solved.glb", solve);
  EXPECT_TRUE(solved.attributes.empty());
  EXPECT_THAT(read("solved.glb"), Not(HasSubstr("oak.png")));
}

using Place = geom::LatticePoint;

/// The outline of a face on a lattice from its first corner in space, with the texture coordinates there.
std::vector<std::pair<Place, std::array<double, 2>>> outline_of(const Scene& scene, scene::FaceId id,
                                                                const geom::Lattice& lattice,
                                                                const std::vector<dvec2>& values) {
  std::vector<std::pair<Place, std::array<double, 2>>> outline;
  std::size_t i = 0;
  for (const scene::VertexId vertex : scene.corners_of(scene.loops_of(scene.faces[id])[0])) {
    outline.push_back({lattice.nearest(scene.vertices[vertex]), {values[i].x, values[i].y}});
    ++i;
  }
  std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end()), outline.end());
  return outline;
}

// Models of the shared corpus: faces that come out as they went in have the same texture coordinates, to the bit.
TEST_F(Attributes, OfRealModelsStayExactWhereNothingWasTouched) {
  const char* const shared = std::getenv("RAD_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "RAD_SHARED is not set";
  for (const char* name : {"bookcase", "glassDoorCabinet", "tatami"}) {
    SCOPED_TRACE(name);
    const std::string path = std::string(shared) + "/corpus/furniture/" + name + ".obj";
    const Scene before = readers::read_file(path).scene;
    const Outcome outcome = outcome_of(&run_radfix, {path, "-o", at("out.obj")});
    ASSERT_LE(outcome.exit_code, 1) << outcome.err;
    const Scene after = readers::read_file(at("out.obj")).scene;
    ASSERT_TRUE(after.recorded);
    const geom::Lattice& lattice = after.recorded->lattice;
    std::map<std::vector<Place>, std::vector<std::vector<std::array<double, 2>>>> known;
    const auto split = [](const auto& outline) {
      std::pair<std::vector<Place>, std::vector<std::array<double, 2>>> parts;
      for (const auto& [place, value] : outline) {
        parts.first.push_back(place);
        parts.second.push_back(value);
      }
      return parts;
    };
    for (scene::FaceId id = 0; id < before.faces.size(); ++id) {
      if (const auto values = tests::texture_of(before, id); !values.empty()) {
        const auto [places, coordinates] = split(outline_of(before, id, lattice, values));
        known[places].push_back(coordinates);
      }
    }
    std::size_t same = 0;
    for (scene::FaceId id = 0; id < after.faces.size(); ++id) {
      if (after.faces[id].loop_count != 1) continue;
      const auto values = tests::texture_of(after, id);
      if (values.empty()) continue;
      const auto [places, coordinates] = split(outline_of(after, id, lattice, values));
      const auto found = known.find(places);
      if (found == known.end()) continue;
      EXPECT_NE(std::ranges::find(found->second, coordinates), found->second.end()) << "face " << id;
      ++same;
    }
    EXPECT_GT(same, 0u);
  }
}

}  // namespace
}  // namespace rad::cli
