// Triangles as few bytes, for a page that holds its model.
//
// Before compression (zlib, RFC 1950) it is a sequence of whole numbers, each in groups of seven bits, the lowest
// first, the top bit set where another follows. A difference d to the number before it is written as 2d, or -2d - 1
// where it is negative.
//   vertices, triangles
//   x of every vertex as differences, in steps of the box; then y; then z
//   corners of every triangle, as differences
//   outline of every triangle: bit i for the edge from corner i to the next
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "bake/scene_triangles.h"
#include "scene/vertex_light.h"

namespace rad::report::html {

/// Steps of a coordinate along the longest side of the box.
inline constexpr std::uint32_t kSteps = (1U << 20U) - 1;

struct PackedGeometry {
  geom::dvec3 low{0, 0, 0};  ///< of the box of all vertices, file units
  double step = 0;           ///< file units
  std::string bytes;         ///< compressed
};

/// zlib (RFC 1950), which browsers inflate by themselves.
std::string compressed(const std::string& bytes);

/// Vertices are those that the triangles use, in order of their first use.
PackedGeometry packed(const scene::Scene& scene, std::span<const bake::DrawnTriangle> triangles);

struct PackedLight {
  double largest = 1;  ///< of all channels, W/m²; above 0
  std::string bytes;   ///< compressed
};

/// Radiosity of the vertices of packed(), in their order: sixteen bits of a half float of radiosity / largest, as
/// differences; red of every vertex, then green, then blue.
PackedLight packed_light(const scene::VertexLight& light, std::span<const bake::DrawnTriangle> triangles);

}  // namespace rad::report::html
