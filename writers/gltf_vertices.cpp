#include "writers/gltf_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::writers::gltf {
namespace {

// Shorter than this a normal is rounding and no direction.
constexpr double kLeastNormal = 1e-6;
// Squared lengths within this of 1 are rounding of what was written as a unit vector: it stays bit for bit.
constexpr double kUnitBand = 0x1p-10;

std::array<float, 3> unit_normal(const geom::dvec3& normal) {
  const double squared = glm::dot(normal, normal);
  const geom::dvec3 unit = std::abs(squared - 1) <= kUnitBand ? normal : normal / std::sqrt(squared);
  return {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)};
}

// Zero without a sign, so that equal values have equal bytes.
float stored(double value) { return static_cast<float>(value) + 0.0f; }

std::array<float, 2> stored_coordinates(const scene::CornerAttributes& attributes, scene::RowId row) {
  const scene::dvec2& value = attributes.texture_coordinates.table[row];
  const bool upper_left = attributes.texture_origin == scene::TextureOrigin::UpperLeft;
  return {stored(value.x), stored(upper_left ? value.y : 1 - value.y)};
}

bool have_directions(const scene::Scene& scene, const scene::Face& face) {
  const scene::CornerValues<geom::dvec3>& normals = scene.attributes.normals;
  if (normals.empty()) return false;
  for (const scene::Loop& loop : scene.loops_of(face)) {
    for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) {
      const scene::RowId row = normals.row(corner);
      if (row == scene::kNoRow || !(glm::length(normals.table[row]) > kLeastNormal)) return false;
    }
  }
  return true;
}

}  // namespace

VertexKind kind_of(const Output& output, const scene::Face& face, bool textured) {
  return {have_directions(output.scene, face), textured || scene::has_texture_coordinates(output.scene, face),
          output.light_map != nullptr};
}

Vertex vertex_at(const Output& output, CornerId corner, VertexKind kind) {
  const scene::Scene& scene = output.scene;
  Vertex vertex;
  vertex.position = scene.corners[corner];
  if (kind.normal) {
    const scene::CornerValues<geom::dvec3>& normals = scene.attributes.normals;
    vertex.normal = unit_normal(normals.table[normals.row(corner)]);
    for (float& component : vertex.normal) component = stored(component);
  }
  if (kind.texture) {
    const scene::RowId row = scene.attributes.texture_coordinates.row(corner);
    if (row != scene::kNoRow) vertex.texture = stored_coordinates(scene.attributes, row);
  }
  if (kind.light_map) {
    const scene::dvec2& at = output.light_map->coordinates[corner];
    vertex.light_map = {stored(at.x), stored(at.y)};
  }
  return vertex;
}

VertexTable::VertexTable(const Output& output, VertexKind kind, std::span<const CornerId> corners)
    : output_(output), kind_(kind) {
  vertices_.reserve(corners.size());
  for (const CornerId corner : corners) vertices_.push_back(vertex_at(output, corner, kind));
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

std::uint32_t VertexTable::index_of(CornerId corner) const {
  const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex_at(output_, corner, kind_));
  return static_cast<std::uint32_t>(found - vertices_.begin());
}

}  // namespace rad::writers::gltf
