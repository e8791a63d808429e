// Scenes to write, and what is compared after they have been read back.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "readers/reader.h"
#include "scene/lattice_model.h"
#include "scene/scene_builder.h"
#include "tests/support/fresh_folder.h"
#include "writers/face_triangles.h"
#include "writers/registry.h"

namespace rad::tests {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string write(const writers::Output& output, const std::filesystem::path& path) {
  return writers::writer_for(path)->write(output, path).problem;
}

inline std::vector<scene::Scene> corpus_scenes() {
  std::vector<scene::Scene> scenes;
  for (const char* name : {"furnished_room", "lamp_post", "lamp_post_repaired", "two_room_flat"}) {
    const auto path = std::filesystem::path(RAD_SOURCE_DIR) / "corpus/models" / (std::string(name) + ".obj");
    scenes.push_back(readers::read_file(path).scene);
    EXPECT_FALSE(scenes.back().faces.empty()) << path;
  }
  return scenes;
}

/// The lattice of a scene with its default T.
inline scene::RecordedLattice lattice_of(const scene::Scene& scene) {
  const scene::LatticeModel model = scene::build_lattice_model(scene);
  return {model.lattice, geom::default_tolerance(scene::tolerance_basis(scene, model)).length};
}

/// Moves the vertices onto a lattice, as radfix does before it writes.
inline void snap(scene::Scene& scene, const geom::Lattice& lattice) {
  for (geom::dvec3& vertex : scene.vertices) vertex = lattice.position(lattice.nearest(vertex));
}

/// The faces that a format of triangles takes.
inline scene::Scene small_faces_of(scene::Scene scene) {
  std::erase_if(scene.faces, [&](const scene::Face& face) { return !writers::triangles_of(scene, face); });
  return scene;
}

inline std::string bits_of(const geom::dvec3& v) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) text += std::to_string(std::bit_cast<std::uint64_t>(v[axis])) + ",";
  return text;
}

/// "object|material|" and the exact places of the corners, for each triangle of the faces, in ascending order.
inline std::vector<std::string> facets_of(const scene::Scene& scene, bool with_names) {
  std::vector<std::string> facets;
  for (const scene::Face& face : scene.faces) {
    const writers::FaceTriangles triangles = writers::triangles_of(scene, face).value();
    for (const writers::Triangle& triangle : triangles) {
      std::string facet;
      if (with_names) facet = scene.objects[face.object] + "|" + scene.materials[face.material].name + "|";
      for (const std::uint32_t corner : triangle) facet += bits_of(scene.vertices[scene.corners[corner]]) + " ";
      facets.push_back(std::move(facet));
    }
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// Every corner of every loop by its place, face by face.
inline std::vector<std::string> polygons_of(const scene::Scene& scene) {
  std::vector<std::string> polygons;
  for (const scene::Face& face : scene.faces) {
    std::string& polygon = polygons.emplace_back();
    for (const scene::Loop& loop : scene.loops_of(face)) {
      polygon += "/";
      for (const scene::VertexId id : scene.corners_of(loop)) polygon += bits_of(scene.vertices[id]) + " ";
    }
  }
  return polygons;
}

/// A square plate in two objects and two materials, away from the origin by `shift`.
inline scene::Scene two_plates(const geom::dvec3& shift = {0, 0, 0}) {
  scene::SceneBuilder builder("plates.obj", "obj");
  for (const geom::dvec3& p : {geom::dvec3{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}) {
    builder.add_vertex(shift + p);
  }
  const scene::MaterialId wall = builder.material("wall");
  builder.material_at(wall).reflectance = {0.7, 0.25, 0.1};
  builder.material_at(wall).reflectance_stated = true;
  const scene::MaterialId lamp = builder.material("lamp");
  builder.material_at(lamp).reflectance_stated = true;
  builder.material_at(lamp).emission = {30, 20, 10};
  builder.use_material(wall);
  builder.use_object(builder.object("left"));
  builder.add_face(std::vector<scene::VertexId>{0, 1, 4, 3}, 0);
  builder.use_material(lamp);
  builder.use_object(builder.object("right"));
  builder.add_face(std::vector<scene::VertexId>{1, 2, 5}, 1);
  builder.use_material(wall);
  builder.add_face(std::vector<scene::VertexId>{1, 5, 4}, 2);
  return builder.take();
}

/// Light that differs from vertex to vertex.
inline scene::VertexLight light_on(const scene::Scene& scene) {
  scene::VertexLight light;
  light.exposure = 0.125;
  light.clamped_share = 0.25;
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    const double b = 0.1 + static_cast<double>(i);
    light.radiosity.emplace_back(b, b / 2, b / 3);
    light.colour.push_back(glm::min(light.exposure * light.radiosity.back(), 1.0));
  }
  return light;
}

}  // namespace rad::tests
