#include "writers/ply_vertices.h"

#include <algorithm>

namespace rad::writers {

PlyVertices::PlyVertices(const scene::Scene& scene) : scene_(scene) {
  if (scene.attributes.empty()) {
    vertices_.resize(scene.vertices.size());
    for (scene::VertexId id = 0; id < vertices_.size(); ++id) vertices_[id].position = id;
    return;
  }
  vertices_.reserve(scene.corners.size());
  for (std::uint32_t corner = 0; corner < scene.corners.size(); ++corner) vertices_.push_back(vertex_at(corner));
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

std::size_t PlyVertices::index_of(std::uint32_t corner) const {
  if (scene_.attributes.empty()) return scene_.corners[corner];
  const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), vertex_at(corner));
  return static_cast<std::size_t>(found - vertices_.begin());
}

PlyVertex PlyVertices::vertex_at(std::uint32_t corner) const {
  PlyVertex vertex;
  vertex.position = scene_.corners[corner];
  const scene::CornerAttributes& attributes = scene_.attributes;
  if (const scene::RowId row = attributes.normals.row(corner); row != scene::kNoRow) {
    const geom::dvec3& normal = attributes.normals.table[row];
    vertex.normal = {normal.x, normal.y, normal.z};
  }
  if (const scene::RowId row = attributes.texture_coordinates.row(corner); row != scene::kNoRow) {
    const scene::dvec2& value = attributes.texture_coordinates.table[row];
    const bool upper_left = attributes.texture_origin == scene::TextureOrigin::UpperLeft;
    vertex.texture = {value.x, upper_left ? 1 - value.y : value.y};
  }
  return vertex;
}

}  // namespace rad::writers
