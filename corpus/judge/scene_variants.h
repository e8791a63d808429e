// The same model written down differently: findings and repair must not change.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "geom/lattice.h"
#include "scene/scene.h"

namespace rad::corpus {

/// 0 to count-1 in an order drawn from `random`.
inline std::vector<std::uint32_t> shuffled(std::size_t count, std::mt19937& random) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

/// What the corners of `original` have, at corners that stand in another order.
template <typename Value>
void carry_rows(const scene::CornerValues<Value>& original, std::span<const std::uint32_t> old_corner,
                scene::CornerValues<Value>& result) {
  result.row_of_corner.clear();
  if (original.empty()) return;
  for (const std::uint32_t corner : old_corner) result.row_of_corner.push_back(original.row(corner));
}

/// The scene with vertices renumbered, faces in another order and every loop started at another corner. Faces and
/// vertices keep their places in the file.
inline scene::Scene rewritten(const scene::Scene& original, std::uint32_t seed) {
  std::mt19937 random(seed);
  scene::Scene result = original;
  const auto vertex_order = shuffled(original.vertices.size(), random);
  std::vector<scene::VertexId> new_id(vertex_order.size());
  for (std::uint32_t i = 0; i < vertex_order.size(); ++i) {
    new_id[vertex_order[i]] = i;
    result.vertices[i] = original.vertices[vertex_order[i]];
    if (!original.vertex_records.empty()) result.vertex_records[i] = original.vertex_records[vertex_order[i]];
  }
  result.faces.clear();
  result.loops.clear();
  result.corners.clear();
  result.smoothing_groups.clear();
  std::vector<std::uint32_t> old_corner;
  for (const std::uint32_t id : shuffled(original.faces.size(), random)) {
    scene::Face face = original.faces[id];
    face.first_loop = static_cast<std::uint32_t>(result.loops.size());
    for (const scene::Loop& loop : original.loops_of(original.faces[id])) {
      const auto corners = original.corners_of(loop);
      result.loops.push_back({static_cast<std::uint32_t>(result.corners.size()), loop.count});
      const std::size_t start = corners.empty() ? 0 : random() % corners.size();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        result.corners.push_back(new_id[corners[(start + i) % corners.size()]]);
        old_corner.push_back(loop.first + static_cast<std::uint32_t>((start + i) % corners.size()));
      }
    }
    result.faces.push_back(face);
    if (!original.smoothing_groups.empty()) result.smoothing_groups.push_back(original.smoothing_groups[id]);
  }
  carry_rows(original.attributes.texture_coordinates, old_corner, result.attributes.texture_coordinates);
  carry_rows(original.attributes.normals, old_corner, result.attributes.normals);
  return result;
}

/// The scene with all coordinates multiplied by 2^exponent, and a declared unit so much smaller: of the same size.
inline scene::Scene scaled(const scene::Scene& original, int exponent) {
  scene::Scene result = original;
  for (geom::dvec3& p : result.vertices) p *= std::ldexp(1.0, exponent);
  if (result.metres_per_unit) *result.metres_per_unit *= std::ldexp(1.0, -exponent);
  return result;
}

/// The scene moved by a power of two along each axis that is larger than its extent; nothing where a coordinate would
/// be rounded.
inline std::optional<scene::Scene> moved(const scene::Scene& original) {
  geom::Box box;
  for (const geom::dvec3& p : original.vertices) {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) box.add(p);
  }
  if (box.empty() || box.largest_magnitude() == 0) return std::nullopt;
  const double step = std::ldexp(1.0, std::ilogb(box.largest_magnitude()) + 2);
  const geom::dvec3 by{step, -2 * step, 4 * step};
  scene::Scene result = original;
  for (geom::dvec3& p : result.vertices) {
    const geom::dvec3 before = p;
    p += by;
    for (int axis = 0; axis < 3; ++axis) {
      const double back = p[axis] - by[axis];
      if (std::isfinite(before[axis]) && back != before[axis]) return std::nullopt;
    }
  }
  return result;
}

/// The scene with z, x, y for x, y, z, seen in a mirror; loops turn the other way, so that fronts stay fronts.
inline scene::Scene mirrored(const scene::Scene& original) {
  scene::Scene result = original;
  for (geom::dvec3& p : result.vertices) p = geom::dvec3(-p.z, p.x, p.y);
  for (const scene::Loop& loop : result.loops) {
    std::reverse(result.corners.begin() + loop.first, result.corners.begin() + loop.first + loop.count);
  }
  return result;
}

}  // namespace rad::corpus
