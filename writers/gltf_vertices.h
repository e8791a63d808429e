// The vertices of one written mesh: positions split where corners of faces differ in what they have beside.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "writers/model.h"

namespace rad::writers::gltf {

/// Index into Scene::corners.
using CornerId = std::uint32_t;

/// What a vertex has beside its position.
struct VertexKind {
  bool normal = false;
  bool texture = false;
  bool light_map = false;
  friend constexpr auto operator<=>(const VertexKind&, const VertexKind&) = default;
};

/// A vertex as it is written; members that its kind lacks are zero.
struct Vertex {
  scene::VertexId position = 0;
  std::array<float, 3> normal{};     ///< of unit length
  std::array<float, 2> texture{};    ///< with the origin at the upper left
  std::array<float, 2> light_map{};  ///< likewise, on its page
  friend constexpr auto operator<=>(const Vertex&, const Vertex&) = default;
};

/// What the corners of a face have; `textured`: its material has an image, so that corners without coordinates get
/// those that a viewer would take, zero. Normals without a direction are none.
VertexKind kind_of(const Output& output, const scene::Face& face, bool textured);

/// The vertex that a corner becomes.
Vertex vertex_at(const Output& output, CornerId corner, VertexKind kind);

/// The vertices of corners of one kind, each once: in the order of the scene's vertices, then of what they have.
class VertexTable {
 public:
  VertexTable(const Output& output, VertexKind kind, std::span<const CornerId> corners);

  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  /// Place of a corner's vertex in vertices().
  [[nodiscard]] std::uint32_t index_of(CornerId corner) const;

 private:
  const Output& output_;
  VertexKind kind_;
  std::vector<Vertex> vertices_;
};

}  // namespace rad::writers::gltf
