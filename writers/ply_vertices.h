// The vertices of a written PLY: those of the scene, split where corners of faces differ in what they have beside.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace rad::writers {

struct PlyVertex {
  scene::VertexId position = 0;
  std::array<double, 3> normal{};   ///< zero where the corner has none
  std::array<double, 2> texture{};  ///< with the origin at the lower left; zero where the corner has none
  friend constexpr auto operator<=>(const PlyVertex&, const PlyVertex&) = default;
};

/// Of a scene without attributes every vertex in its order. Else each that a corner becomes, once: in the order of the
/// scene's vertices, then of what they have.
class PlyVertices {
 public:
  explicit PlyVertices(const scene::Scene& scene);

  [[nodiscard]] const std::vector<PlyVertex>& all() const { return vertices_; }
  /// Place in all() of the vertex of a corner, an index into Scene::corners.
  [[nodiscard]] std::size_t index_of(std::uint32_t corner) const;

 private:
  [[nodiscard]] PlyVertex vertex_at(std::uint32_t corner) const;

  const scene::Scene& scene_;
  std::vector<PlyVertex> vertices_;
};

}  // namespace rad::writers
