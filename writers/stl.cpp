#include "writers/stl.h"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

#include "writers/face_triangles.h"
#include "writers/head_comments.h"
#include "writers/little_endian.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

constexpr std::size_t kHeaderBytes = 80;

bool append_floats(std::string& bytes, const geom::dvec3& value) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto stored = static_cast<float>(value[axis]);
    if (!std::isfinite(stored)) return false;
    append_bytes(bytes, stored);
  }
  return true;
}

// Zero for a triangle without area, as the format has it.
geom::dvec3 normal_of(const geom::dvec3& a, const geom::dvec3& b, const geom::dvec3& c) {
  const geom::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 && std::isfinite(length) ? normal / length : geom::dvec3(0.0);
}

bool append_facet(std::string& bytes, const scene::Scene& scene, const Triangle& triangle) {
  const auto corner_at = [&](std::size_t i) { return scene.vertices[scene.corners[triangle[i]]]; };
  const geom::dvec3 a = corner_at(0), b = corner_at(1), c = corner_at(2);
  bool sound = append_floats(bytes, normal_of(a, b, c));
  for (const geom::dvec3& corner : {a, b, c}) sound = sound && append_floats(bytes, corner);
  append_bytes(bytes, std::uint16_t{0});
  return sound;
}

}  // namespace

WriteResult write_stl(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  const scene::Scene& scene = output.scene;
  std::string facets;
  std::uint64_t count = 0;
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const auto triangles = triangles_of(scene, scene.faces[id]);
    if (!triangles) return {unsplit_face(id)};
    for (const Triangle& triangle : *triangles) {
      if (!append_facet(facets, scene, triangle)) return {"face " + std::to_string(id) + " is beyond single precision"};
      ++count;
    }
  }
  if (count > std::numeric_limits<std::uint32_t>::max()) return {"STL counts up to 2^32 - 1 triangles"};
  std::string bytes = "written by " + program_name();
  bytes.resize(kHeaderBytes, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(count));
  return {write_whole_file(path, bytes + facets)};
}

}  // namespace rad::writers
