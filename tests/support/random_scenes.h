// Random scenes in which everything that is hard on a judge happens: boxes that touch, overlap and pierce each other,
// sheets that nearly coincide, doubled faces, needles.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scene/scene_builder.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

/// Tolerance of these scenes, file units. Coordinates are whole, or whole plus a few 1024ths: lattice points on any
/// lattice that a scene of up to some thousand units gets.
inline constexpr double kSceneTolerance = 1.0 / 16;
inline constexpr std::array<double, 4> kSmallOffsets{0, 20.0 / 1024, 58.0 / 1024, 70.0 / 1024};  ///< 0 to 1.1 T

class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed), builder_("scene.obj", "obj") {
    builder_.add_section({"scene.obj", "", scene::RecordKind::Line});
  }

  /// Axis-parallel closed box between whole coordinates, faces outward.
  void add_box() {
    const scene::dvec3 low = whole_point();
    const scene::dvec3 high = low + scene::dvec3(random_.between(1, 4), random_.between(1, 4), random_.between(1, 4));
    begin_object();
    std::array<scene::VertexId, 8> v;
    for (std::size_t i = 0; i < 8; ++i) {
      v[i] = builder_.add_vertex({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : kSides) add_face({v[side[0]], v[side[1]], v[side[2]], v[side[3]]});
  }

  /// Rectangle parallel to two axes, off the grid by a part of T along the third.
  void add_sheet() {
    const auto u = static_cast<int>(random_.between(0, 2));
    const int v = (u + 1) % 3, w = (u + 2) % 3;
    scene::dvec3 corner = whole_point(), along_u(0, 0, 0), along_v(0, 0, 0);
    corner[w] += kSmallOffsets[static_cast<std::size_t>(random_.between(0, 3))];
    along_u[u] = static_cast<double>(random_.between(1, 5));
    along_v[v] = static_cast<double>(random_.between(1, 5));
    begin_object();
    add_polygon({corner, corner + along_u, corner + along_u + along_v, corner + along_v});
  }

  /// Triangle between any three whole points.
  void add_triangle() {
    begin_object();
    const scene::dvec3 a = whole_point(), b = whole_point();
    add_polygon({a, b, whole_point()});
  }

  /// Parallelogram between whole points, parallel to no axis.
  void add_tilted_sheet() {
    begin_object();
    const scene::dvec3 a = whole_point(), b = whole_point(), c = whole_point();
    add_polygon({a, b, b + (c - a), c});
  }

  /// Square with a square hole, or an L.
  void add_concave_face() {
    begin_object();
    const scene::dvec3 a = whole_point();
    const auto at = [&](double x, double y) { return a + scene::dvec3(x, y, 0); };
    if (random_.one_in(2)) {
      add_polygon({at(0, 0), at(4, 0), at(4, 2), at(2, 2), at(2, 4), at(0, 4)});
      return;
    }
    add_polygon({at(0, 0), at(6, 0), at(6, 6), at(0, 6)});
    builder_.add_hole(std::vector{builder_.add_vertex(at(2, 2)), builder_.add_vertex(at(2, 4)),
                                  builder_.add_vertex(at(4, 4)), builder_.add_vertex(at(4, 2))});
  }

  /// A triangle about as thick as T, or thinner.
  void add_needle() {
    begin_object();
    const scene::dvec3 a = whole_point();
    add_polygon({a, a + scene::dvec3(8, 2, 0), a + scene::dvec3(4, 1, kSmallOffsets[random_.one_in(2) ? 1 : 3])});
  }

  /// A face that is there already, once more, with vertices of its own; every other time the other way round.
  void add_duplicate() {
    if (builder_.scene().faces.empty()) return;
    const auto last = static_cast<std::int64_t>(builder_.scene().faces.size()) - 1;
    const scene::Face face = builder_.scene().faces[static_cast<std::size_t>(random_.between(0, last))];
    std::vector<scene::dvec3> corners;
    for (const scene::VertexId id : builder_.scene().corners_of(builder_.scene().loops[face.first_loop])) {
      corners.push_back(builder_.scene().vertices[id]);
    }
    if (random_.one_in(2)) std::reverse(corners.begin(), corners.end());
    if (random_.one_in(2)) begin_object();
    add_polygon(corners);
  }

  [[nodiscard]] LatticeRandom& random() { return random_; }
  scene::Scene take() { return builder_.take(); }

 private:
  scene::dvec3 whole_point() {
    const geom::LatticePoint p = random_.grid_point(4, 1);
    return {p.x, p.y, p.z};
  }

  // Few names, so that things often are of one object or material.
  void begin_object() {
    builder_.use_object(builder_.object("object" + std::to_string(random_.between(1, 4))));
    builder_.use_material(builder_.material("material" + std::to_string(random_.between(1, 2))));
  }

  void add_polygon(const std::vector<scene::dvec3>& corners) {
    std::vector<scene::VertexId> ids;
    for (const scene::dvec3& corner : corners) ids.push_back(builder_.add_vertex(corner));
    add_face(ids);
  }

  void add_face(const std::vector<scene::VertexId>& ids) { builder_.add_face(ids, builder_.scene().faces.size() + 1); }

  LatticeRandom random_;
  scene::SceneBuilder builder_;
};

/// Whole coordinates only: whatever meets, meets over much more than T, and whatever does not is further apart.
inline scene::Scene coarse_scene(std::uint64_t seed) {
  RandomScene scene(seed);
  const std::int64_t parts = scene.random().between(2, 7);
  for (std::int64_t i = 0; i < parts; ++i) {
    switch (scene.random().between(0, 5)) {
      case 0:
        scene.add_triangle();
        break;
      case 1:
        scene.add_tilted_sheet();
        break;
      case 2:
        scene.add_concave_face();
        break;
      default:
        scene.add_box();
    }
  }
  return scene.take();
}

/// With parts that are off by about T, doubled or thin.
inline scene::Scene fine_scene(std::uint64_t seed) {
  RandomScene scene(seed);
  const std::int64_t parts = scene.random().between(3, 9);
  for (std::int64_t i = 0; i < parts; ++i) {
    switch (scene.random().between(0, 7)) {
      case 0:
        scene.add_triangle();
        break;
      case 1:
        scene.add_tilted_sheet();
        break;
      case 2:
        scene.add_concave_face();
        break;
      case 3:
        scene.add_needle();
        break;
      case 4:
        scene.add_duplicate();
        break;
      case 5:
        scene.add_box();
        break;
      default:
        scene.add_sheet();
    }
  }
  return scene.take();
}

}  // namespace rad::tests
