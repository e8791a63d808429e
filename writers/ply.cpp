#include "writers/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "writers/bridged_ring.h"
#include "writers/head_comments.h"
#include "writers/little_endian.h"
#include "writers/ply_vertices.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

/// Indices into Scene::corners.
using Ring = std::vector<std::uint32_t>;

std::vector<Ring> rings_of(const scene::Scene& scene) {
  std::vector<Ring> rings;
  for (const scene::Face& face : scene.faces) {
    Ring ring = bridged_ring(scene, face);
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

bool fit_bytes(const std::vector<Ring>& rings) {
  return std::ranges::all_of(rings,
                             [](const Ring& ring) { return ring.size() <= std::numeric_limits<std::uint8_t>::max(); });
}

std::string header(const Output& output, std::size_t vertices, const std::vector<Ring>& rings) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : head_comments(output)) text += "comment " + comment + "\n";
  if (output.light != nullptr) {
    text += fmt::format("comment radfix exposure={} clampedShare={} curve={}\n", output.light->exposure,
                        output.light->clamped_share, scene::name(output.light->curve));
  }
  text += fmt::format("element vertex {}\n", vertices);
  for (const char* axis : {"x", "y", "z"}) text += fmt::format("property double {}\n", axis);
  if (!output.scene.attributes.normals.empty()) {
    for (const char* axis : {"nx", "ny", "nz"}) text += fmt::format("property double {}\n", axis);
  }
  if (!output.scene.attributes.texture_coordinates.empty()) {
    for (const char* axis : {"s", "t"}) text += fmt::format("property double {}\n", axis);
  }
  if (output.light != nullptr) {
    for (const char* channel : {"r", "g", "b"}) text += fmt::format("property double B_{}\n", channel);
    for (const char* channel : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", channel);
  }
  text += fmt::format("element face {}\nproperty list {} int vertex_indices\nend_header\n", rings.size(),
                      fit_bytes(rings) ? "uchar" : "uint");
  return text;
}

void append_triple(std::string& bytes, const geom::dvec3& value) {
  for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, value[axis]);
}

// IEC 61966-2-1.
std::uint8_t srgb_byte(double linear) {
  const double clamped = std::clamp(linear, 0.0, 1.0);
  const double encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

void append_light(std::string& bytes, const scene::VertexLight& light, std::size_t vertex) {
  append_triple(bytes, light.radiosity[vertex]);
  for (int channel = 0; channel < 3; ++channel) append_bytes(bytes, srgb_byte(light.colour[vertex][channel]));
}

void append_attributes(std::string& bytes, const scene::CornerAttributes& attributes, const PlyVertex& vertex) {
  if (!attributes.normals.empty()) {
    for (const double component : vertex.normal) append_bytes(bytes, component);
  }
  if (!attributes.texture_coordinates.empty()) {
    for (const double component : vertex.texture) append_bytes(bytes, component);
  }
}

void append_ring(std::string& bytes, const Ring& ring, const PlyVertices& vertices, bool count_fits_byte) {
  if (count_fits_byte) {
    append_bytes(bytes, static_cast<std::uint8_t>(ring.size()));
  } else {
    append_bytes(bytes, static_cast<std::uint32_t>(ring.size()));
  }
  for (const std::uint32_t corner : ring) {
    append_bytes(bytes, static_cast<std::int32_t>(vertices.index_of(corner)));
  }
}

}  // namespace

WriteResult write_ply(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  const scene::Scene& scene = output.scene;
  const PlyVertices vertices(scene);
  if (vertices.all().size() > std::numeric_limits<std::int32_t>::max()) return {"PLY counts vertices up to 2^31"};
  const std::vector<Ring> rings = rings_of(scene);
  std::string bytes = header(output, vertices.all().size(), rings);
  for (const PlyVertex& vertex : vertices.all()) {
    append_triple(bytes, scene.vertices[vertex.position]);
    append_attributes(bytes, scene.attributes, vertex);
    if (output.light != nullptr) append_light(bytes, *output.light, vertex.position);
  }
  const bool count_fits_byte = fit_bytes(rings);
  for (const Ring& ring : rings) append_ring(bytes, ring, vertices, count_fits_byte);
  return {write_whole_file(path, bytes)};
}

}  // namespace rad::writers
