// Scenes for tests of pictures.
#pragma once

#include <array>
#include <vector>

#include "scene/scene_builder.h"

namespace rad::tests {

/// Adds a face through these points.
inline void add_polygon(scene::SceneBuilder& builder, const std::vector<geom::dvec3>& points) {
  std::vector<scene::VertexId> corners;
  for (const geom::dvec3& point : points) corners.push_back(builder.add_vertex(point));
  builder.add_face(corners, 0);
}

enum class Facing { Outward, Inward };

/// A box with its six sides as quadrilaterals.
inline void add_box(scene::SceneBuilder& builder, const geom::dvec3& low, const geom::dvec3& high, Facing facing) {
  const auto corner = [&](int i) {
    return geom::dvec3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  };
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : kSides) {
    std::vector<geom::dvec3> points{corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])};
    if (facing == Facing::Inward) std::swap(points[1], points[3]);
    add_polygon(builder, points);
  }
}

inline scene::Scene box_scene(Facing facing, scene::UpAxis up = scene::UpAxis::Z) {
  scene::SceneBuilder builder("box.obj", "obj");
  builder.add_section({.file = "box.obj", .pointer = {}, .kind = scene::RecordKind::Line});
  add_box(builder, {0, 0, 0}, {4, 3, 2}, facing);
  builder.scene().up = up;
  return builder.take();
}

}  // namespace rad::tests
