#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "corpus/generate/kept_files.h"
#include "corpus/generate/models.h"
#include "readers/reader.h"

namespace rad::corpus {
namespace {

using geom::dvec3;
using scene::Scene;
using Place = std::array<double, 3>;

const std::filesystem::path kModels = std::filesystem::path(RAD_SOURCE_DIR) / "corpus" / "models";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(KeptFiles, AreWhatTheGeneratorWrites) {
  std::set<std::string> made;
  for (const KeptFile& file : kept_files()) {
    EXPECT_TRUE(bytes_of(kModels / file.name) == file.bytes) << file.name << ": run rad_corpus --out corpus/models";
    made.insert(file.name);
  }
  std::set<std::string> kept;
  for (const auto& entry : std::filesystem::directory_iterator(kModels)) kept.insert(entry.path().filename().string());
  EXPECT_EQ(kept, made);
}

Place place(const dvec3& p) { return {p.x, p.y, p.z}; }

/// Directed edges by place, of the faces of one object; a bridge cancels itself.
using EdgeCounts = std::map<std::pair<Place, Place>, int>;

std::map<std::string, EdgeCounts> edges_by_object(const Scene& scene) {
  std::map<std::string, EdgeCounts> objects;
  for (const scene::Face& face : scene.faces) {
    EdgeCounts own;
    for (const scene::Loop& loop : scene.loops_of(face)) {
      const auto corners = scene.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place a = place(scene.vertices[corners[i]]);
        const Place b = place(scene.vertices[corners[(i + 1) % corners.size()]]);
        ++own[{a, b}];
      }
    }
    for (const auto& [edge, count] : own) {
      const auto back = own.find({edge.second, edge.first});
      const int left = count - (back == own.end() ? 0 : back->second);
      if (left > 0) objects[scene.objects[face.object]][edge] += left;
    }
  }
  return objects;
}

bool is_closed(const EdgeCounts& edges) {
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}

dvec3 cross(const dvec3& a, const dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

dvec3 area_vector(const Scene& scene, const scene::Face& face) {
  dvec3 sum{0, 0, 0};
  for (const scene::Loop& loop : scene.loops_of(face)) {
    const auto corners = scene.corners_of(loop);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      sum += cross(scene.vertices[corners[i]], scene.vertices[corners[(i + 1) % corners.size()]]) * 0.5;
    }
  }
  return sum;
}

std::map<std::string, double> volume_by_object(const Scene& scene) {
  std::map<std::string, double> volumes;
  for (const scene::Face& face : scene.faces) {
    const dvec3& anchor = scene.vertices[scene.corners[scene.loops[face.first_loop].first]];
    volumes[scene.objects[face.object]] += dot(area_vector(scene, face), anchor) / 3;
  }
  return volumes;
}

// Every corner of a face lies in its plane, by distance.
double largest_warp(const Scene& scene) {
  double warp = 0;
  for (const scene::Face& face : scene.faces) {
    const dvec3 area = area_vector(scene, face);
    const dvec3 normal = area / std::sqrt(dot(area, area));
    const dvec3& anchor = scene.vertices[scene.corners[scene.loops[face.first_loop].first]];
    for (const scene::Loop& loop : scene.loops_of(face)) {
      for (const scene::VertexId id : scene.corners_of(loop)) {
        warp = std::max(warp, std::abs(dot(normal, scene.vertices[id] - anchor)));
      }
    }
  }
  return warp;
}

// Pairs of a used vertex and an edge that it lies inside of, within a tenth of a millimetre.
std::size_t t_vertices(const Scene& scene) {
  constexpr double kNear = 1e-4;
  std::set<Place> places;
  for (const scene::VertexId id : scene.corners) places.insert(place(scene.vertices[id]));
  std::set<std::pair<Place, Place>> edges;
  for (const auto& [name, counts] : edges_by_object(scene)) {
    for (const auto& [edge, count] : counts) edges.insert(std::minmax(edge.first, edge.second));
  }
  std::size_t found = 0;
  for (const auto& [from, to] : edges) {
    const dvec3 a(from[0], from[1], from[2]), along = dvec3(to[0], to[1], to[2]) - a;
    const double length = std::sqrt(dot(along, along));
    for (const Place& p : places) {
      const dvec3 offset = dvec3(p[0], p[1], p[2]) - a;
      const double reach = dot(offset, along) / length;
      if (reach < kNear || reach > length - kNear) continue;
      const dvec3 aside = offset - along * (reach / length);
      if (dot(aside, aside) < kNear * kNear) ++found;
    }
  }
  return found;
}

const std::set<std::string> kOpenObjects{"ground", "light_panel"};

TEST(CleanModels, HaveClosedObjectsFlatFacesAndNoTVertices) {
  for (const Model& model : kept_models()) {
    if (!model.clean) continue;
    SCOPED_TRACE(model.name);
    const readers::ReadResult read = readers::read_file(kModels / (std::string(model.name) + ".obj"));
    EXPECT_TRUE(read.issues.all().empty());
    for (const Scene& scene : {model.make(), read.scene}) {
      auto edges = edges_by_object(scene);
      // The panel of light fills a hole of the room: together they are closed.
      edges["room"].merge(edges["light_panel"]);
      for (const auto& [name, counts] : edges) {
        if (kOpenObjects.contains(name)) continue;
        EXPECT_TRUE(is_closed(counts)) << name;
      }
      EXPECT_LT(largest_warp(scene), 1e-9);
      EXPECT_EQ(t_vertices(scene), 0u);
    }
  }
}

TEST(CleanModels, HaveTheirFrontsOutside) {
  for (const Model& model : kept_models()) {
    SCOPED_TRACE(model.name);
    for (const auto& [name, volume] : volume_by_object(model.make())) {
      if (kOpenObjects.contains(name)) continue;
      if (name == "room") {
        EXPECT_LT(volume, 0) << "the room is seen from inside";
      } else {
        EXPECT_GT(volume, 0) << name;
      }
    }
  }
}

TEST(CleanModels, HaveALightAndStateEveryReflectance) {
  for (const Model& model : kept_models()) {
    SCOPED_TRACE(model.name);
    const Scene scene = model.make();
    bool emits = false;
    for (const scene::Face& face : scene.faces) {
      const scene::Material& material = scene.materials[face.material];
      EXPECT_TRUE(material.reflectance_stated) << material.name;
      emits |= material.emits();
    }
    EXPECT_TRUE(emits);
  }
}

TEST(LampPost, IsBrokenInTheWaysOfColorPlate1) {
  const Scene broken = lamp_post(), repaired = lamp_post_repaired();
  EXPECT_GT(t_vertices(broken), 0u);
  std::size_t ground_before = 0, ground_after = 0;
  for (const scene::Face& face : broken.faces) ground_before += broken.objects[face.object] == "ground" ? 1 : 0;
  for (const scene::Face& face : repaired.faces) ground_after += repaired.objects[face.object] == "ground" ? 1 : 0;
  EXPECT_EQ(ground_before, 8u);
  EXPECT_EQ(ground_after, 3u) << "the ground, and what box and post cover of it";
}

TEST(LampPost, KeepsItsAreaInRepair) {
  const auto area = [](const Scene& scene, const std::string& object) {
    double sum = 0;
    for (const scene::Face& face : scene.faces) {
      const dvec3 vector = area_vector(scene, face);
      if (scene.objects[face.object] == object) sum += std::sqrt(dot(vector, vector));
    }
    return sum;
  };
  const Scene broken = lamp_post(), repaired = lamp_post_repaired();
  for (const std::string name : {"ground", "box", "post", "lamp"}) {
    EXPECT_NEAR(area(broken, name), area(repaired, name), 1e-9) << name;
  }
}

TEST(LargeModels, AreClosedAndOfTheSizeAskedFor) {
  const Scene sphere = clean_sphere(2000);
  EXPECT_EQ(sphere.faces.size(), 2000u);
  EXPECT_EQ(sphere.vertices.size(), 1002u);
  EXPECT_TRUE(is_closed(edges_by_object(sphere)["sphere"]));
  EXPECT_NEAR(volume_by_object(sphere)["sphere"], 4.0 / 3 * 3.14159265 * 1000, 30);

  const Scene terrain = clean_terrain(20);
  EXPECT_EQ(terrain.faces.size(), 800u);
  EXPECT_EQ(terrain.vertices.size(), 441u);
  for (const scene::Face& face : terrain.faces) EXPECT_GT(area_vector(terrain, face).z, 0);

  const Scene city = clean_city(4);
  const auto blocks = edges_by_object(city);
  EXPECT_EQ(blocks.size(), 17u);
  for (const auto& [name, counts] : blocks) EXPECT_TRUE(is_closed(counts)) << name;
}

}  // namespace
}  // namespace rad::corpus
