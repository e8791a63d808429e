// Clean meshes of any size, for benchmarks and properties.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "corpus/generate/models.h"
#include "corpus/generate/shapes.h"

namespace rad::corpus {
namespace {

using geom::dvec3;
using scene::VertexId;

scene::SceneBuilder builder_in_metres(const std::string& name) {
  scene::SceneBuilder builder(name, "obj");
  builder.add_section({name, "", scene::RecordKind::Element});
  builder.scene().metres_per_unit = 1;
  builder.scene().up = scene::UpAxis::Z;
  scene::Material& plain = builder.material_at(builder.material("plain"));
  plain.reflectance = {0.6, 0.6, 0.6};
  plain.reflectance_stated = true;
  builder.use_material(builder.material("plain"));
  return builder;
}

dvec3 rounded_to_micrometres(const dvec3& p) {
  constexpr double kPerMetre = 1e6;
  return {std::round(p.x * kPerMetre) / kPerMetre, std::round(p.y * kPerMetre) / kPerMetre,
          std::round(p.z * kPerMetre) / kPerMetre};
}

struct Icosahedron {
  std::array<dvec3, 12> corners;
  std::array<std::array<int, 3>, 20> faces;
};

Icosahedron icosahedron() {
  constexpr double g = std::numbers::phi;
  return {{{{-1, g, 0},
            {1, g, 0},
            {-1, -g, 0},
            {1, -g, 0},
            {0, -1, g},
            {0, 1, g},
            {0, -1, -g},
            {0, 1, -g},
            {g, 0, -1},
            {g, 0, 1},
            {-g, 0, -1},
            {-g, 0, 1}}},
          {{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}}};
}

/// Points of a geodesic grid, one vertex for each whatever face asks.
class Geodesic {
 public:
  Geodesic(scene::SceneBuilder& builder, int frequency) : builder_(builder), frequency_(frequency) {}

  // The point with weights (frequency - j - k, j, k) at the corners of `face`.
  VertexId vertex(const std::array<int, 3>& face, int j, int k) {
    std::array<std::pair<int, int>, 3> weights{{{face[0], frequency_ - j - k}, {face[1], j}, {face[2], k}}};
    // In the order of corner ids and without zero weights, both faces at an edge name its points alike.
    std::sort(weights.begin(), weights.end());
    std::array<int, 6> name{-1, 0, -1, 0, -1, 0};
    dvec3 sum{0, 0, 0};
    std::size_t used = 0;
    for (const auto& [corner, weight] : weights) {
      if (weight == 0) continue;
      name[2 * used] = corner;
      name[2 * used++ + 1] = weight;
      sum += static_cast<double>(weight) * shape_.corners[static_cast<std::size_t>(corner)];
    }
    const auto [entry, fresh] = vertices_.try_emplace(name, 0);
    if (fresh) entry->second = builder_.add_vertex(rounded_to_micrometres(kRadius * glm::normalize(sum)));
    return entry->second;
  }

  void add_faces() {
    std::uint64_t record = 0;
    for (const auto& face : shape_.faces) {
      for (int j = 0; j < frequency_; ++j) {
        for (int k = 0; j + k < frequency_; ++k) {
          const VertexId b = vertex(face, j + 1, k), c = vertex(face, j, k + 1);
          builder_.add_face(std::array{vertex(face, j, k), b, c}, record++);
          if (j + k + 1 < frequency_) builder_.add_face(std::array{b, vertex(face, j + 1, k + 1), c}, record++);
        }
      }
    }
  }

 private:
  static constexpr double kRadius = 10;

  scene::SceneBuilder& builder_;
  int frequency_;
  Icosahedron shape_ = icosahedron();
  std::map<std::array<int, 6>, VertexId> vertices_;
};

// A whole number below `range` that depends on both arguments only.
int scattered(std::uint64_t a, std::uint64_t b, int range) {
  std::uint64_t h = a * 0x9e3779b97f4a7c15ull + b * 0xc2b2ae3d27d4eb4full + 0x165667b19e3779f9ull;
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 32)) * 0x94d049bb133111ebull;
  return static_cast<int>((h ^ (h >> 31)) % static_cast<std::uint64_t>(range));
}

// Hills in millimetres: heights scattered over a coarse grid, bilinear between, and a small roughness of each point.
int terrain_height(std::size_t i, std::size_t j) {
  constexpr std::size_t kCoarse = 8;
  constexpr int kHill = 3000, kRoughness = 160;
  const std::size_t a = i / kCoarse, b = j / kCoarse;
  const int s = static_cast<int>(i % kCoarse), t = static_cast<int>(j % kCoarse), n = static_cast<int>(kCoarse);
  const auto hill = [](std::size_t u, std::size_t v) { return scattered(u, v, kHill); };
  const int smooth = ((n - s) * (n - t) * hill(a, b) + s * (n - t) * hill(a + 1, b) + (n - s) * t * hill(a, b + 1) +
                      s * t * hill(a + 1, b + 1)) /
                     (n * n);
  return smooth + scattered(i + 977, j + 31, kRoughness);
}

}  // namespace

scene::Scene clean_sphere(std::size_t triangles) {
  const auto frequency = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 20)));
  scene::SceneBuilder builder = builder_in_metres("sphere.obj");
  builder.use_object(builder.object("sphere"));
  Geodesic(builder, std::max(1, frequency)).add_faces();
  return builder.take();
}

scene::Scene clean_terrain(std::size_t n) {
  scene::SceneBuilder builder = builder_in_metres("terrain.obj");
  builder.use_object(builder.object("terrain"));
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      builder.add_vertex({static_cast<double>(i), static_cast<double>(j), terrain_height(i, j) / 1000.0});
    }
  }
  std::uint64_t record = 0;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto a = static_cast<VertexId>(j * (n + 1) + i), d = static_cast<VertexId>(a + n + 1);
      builder.add_face(std::array{a, a + 1, d + 1}, record++);
      builder.add_face(std::array{a, d + 1, d}, record++);
    }
  }
  return builder.take();
}

scene::Scene clean_city(std::size_t n) {
  constexpr int kPitch = 24000;
  Modeller modeller("city.obj");
  modeller.define_material("brick", {0.45, 0.3, 0.25});
  modeller.define_material("roof", {0.3, 0.3, 0.32});
  modeller.define_material("sun", {0.8, 0.8, 0.8}, {5000, 4900, 4600});
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto chance = [&](std::uint64_t salt, int range) { return scattered(i * 7919 + salt, j, range); };
      const Frame frame = plan_at({static_cast<int>(i) * kPitch, static_cast<int>(j) * kPitch, 0});
      const Outline outline =
          rectangle({chance(1, 3000), chance(2, 3000)}, {14000 + chance(3, 6000), 14000 + chance(4, 6000)});
      const int height = 6000 + chance(5, 40000);
      modeller.begin_object("block_" + std::to_string(i + 1) + "_" + std::to_string(j + 1));
      modeller.paint("brick");
      panel(modeller, frame, outline, 0, Facing::Against);
      sides(modeller, frame, outline, 0, height);
      modeller.paint("roof");
      panel(modeller, frame, outline, height, Facing::Along);
    }
  }
  const int middle = static_cast<int>(n) * kPitch / 2;
  modeller.begin_object("sun");
  modeller.paint("sun");
  prism(modeller, plan_at({middle, middle, 0}), rectangle({-1500, -1500}, {1500, 1500}), 70000, 72000);
  return modeller.take();
}

std::span<const Model> kept_models() {
  static constexpr std::array<Model, 4> kModels{{{"lamp_post", lamp_post, false},
                                                 {"lamp_post_repaired", lamp_post_repaired},
                                                 {"furnished_room", furnished_room},
                                                 {"two_room_flat", two_room_flat}}};
  return kModels;
}

std::span<const Model> made_models() {
  static constexpr std::array<Model, 2> kModels{{{"house", house, false}, {"theatre", theatre, false}}};
  return kModels;
}

}  // namespace rad::corpus
