#include "bake/scene_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/constrained_triangulation.h"
#include "scene/lattice_model.h"

namespace rad::bake {
namespace {

using geom::PlanarPoint;
using scene::Face;
using scene::LatticeModel;
using scene::Loop;
using scene::Scene;
using scene::VertexId;

class Splitter {
 public:
  Splitter(const Scene& scene, const LatticeModel& model) : scene_(scene), model_(model) {}

  std::vector<DrawnTriangle> take() {
    for (scene::FaceId id = 0; id < scene_.faces.size(); ++id) {
      if (model_.left_out[id]) continue;
      const std::size_t first = triangles_.size();
      split(scene_.faces[id]);
      for (std::size_t i = first; i < triangles_.size(); ++i) triangles_[i].face = id;
    }
    return std::move(triangles_);
  }

 private:
  void split(const Face& face) {
    const auto outer = scene_.corners_of(scene_.loops[face.first_loop]);
    if (outer.size() < 3) return;
    if (face.loop_count == 1 && outer.size() == 3) {
      triangles_.push_back({{outer[0], outer[1], outer[2]}});
      return;
    }
    choose_projection(face);
    if (face.loop_count == 1 && outer.size() == 4 && is_strictly_convex(outer)) return split_quadrilateral(outer);
    if (!split_rings(face)) fan(outer);
  }

  void choose_projection(const Face& face) {
    geom::dvec3 normal{0, 0, 0};
    for (const Loop& loop : scene_.loops_of(face)) {
      const auto corners = model_.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto a = geom::as_vector(model_.points[corners[i]]);
        const auto b = geom::as_vector(model_.points[corners[(i + 1) % corners.size()]]);
        normal += geom::dvec3{(a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)};
      }
    }
    dropped_ = 2;
    if (std::abs(normal.y) > std::abs(normal[dropped_])) dropped_ = 1;
    if (std::abs(normal.x) > std::abs(normal[dropped_])) dropped_ = 0;
    turned_ = normal[dropped_] < 0;
  }

  const geom::LatticePoint& lattice_point(VertexId vertex) const {
    return model_.points[model_.point_of_vertex[vertex]];
  }
  PlanarPoint planar(VertexId vertex) const { return geom::project(lattice_point(vertex), dropped_); }

  bool is_strictly_convex(std::span<const VertexId> corners) const {
    const geom::Sign wanted = turned_ ? geom::Sign::Negative : geom::Sign::Positive;
    for (std::size_t i = 0; i < 4; ++i) {
      const geom::Sign turn =
          geom::orient2d(planar(corners[i]), planar(corners[(i + 1) % 4]), planar(corners[(i + 2) % 4]));
      if (turn != wanted) return false;
    }
    return true;
  }

  void split_quadrilateral(std::span<const VertexId> c) {
    const auto first = geom::squared_distance(lattice_point(c[0]), lattice_point(c[2]));
    const auto second = geom::squared_distance(lattice_point(c[1]), lattice_point(c[3]));
    const std::size_t from = first <= second ? 0 : 1;
    for (const std::size_t i : {from, from + 2}) {
      triangles_.push_back({{c[i % 4], c[(i + 1) % 4], c[(i + 2) % 4]}, {true, true, false}});
    }
  }

  // Corners that share a projected point are one there: the first of the face stands for all.
  bool split_rings(const Face& face) {
    std::vector<std::pair<PlanarPoint, VertexId>> placed;
    for (const Loop& loop : scene_.loops_of(face)) {
      for (const VertexId vertex : scene_.corners_of(loop)) placed.emplace_back(planar(vertex), vertex);
    }
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(placed.begin(), placed.end(), before);
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    placed.erase(std::unique(placed.begin(), placed.end(), same), placed.end());
    std::vector<PlanarPoint> points;
    for (const auto& [point, vertex] : placed) points.push_back(point);

    std::vector<std::vector<std::uint32_t>> rings;
    for (const Loop& loop : scene_.loops_of(face)) {
      std::vector<std::uint32_t> ring = ring_of(points, scene_.corners_of(loop));
      if (ring.size() >= 3) rings.push_back(std::move(ring));
    }
    if (rings.empty()) return false;
    const auto pieces = geom::triangulate_rings(points, rings);
    for (const geom::PolygonTriangle& piece : pieces) {
      const std::array corners{placed[piece.corners[0]].second, placed[piece.corners[1]].second,
                               placed[piece.corners[2]].second};
      const auto& b = piece.boundary;
      triangles_.push_back(turned_ ? DrawnTriangle{{corners[0], corners[2], corners[1]}, {b[2], b[1], b[0]}}
                                   : DrawnTriangle{corners, b});
    }
    return !pieces.empty();
  }

  std::vector<std::uint32_t> ring_of(const std::vector<PlanarPoint>& points, std::span<const VertexId> corners) const {
    std::vector<std::uint32_t> ring;
    for (const VertexId vertex : corners) {
      const auto found = std::lower_bound(points.begin(), points.end(), planar(vertex));
      const auto index = static_cast<std::uint32_t>(found - points.begin());
      if (ring.empty() || ring.back() != index) ring.push_back(index);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  void fan(std::span<const VertexId> corners) {
    const std::size_t last = corners.size() - 2;
    for (std::size_t i = 1; i <= last; ++i) {
      triangles_.push_back({{corners[0], corners[i], corners[i + 1]}, {i == 1, true, i == last}});
    }
  }

  const Scene& scene_;
  const LatticeModel& model_;
  int dropped_ = 2;
  bool turned_ = false;
  std::vector<DrawnTriangle> triangles_;
};

}  // namespace

std::vector<DrawnTriangle> drawn_triangles(const Scene& scene) {
  const LatticeModel model = scene::build_lattice_model(scene);
  return Splitter(scene, model).take();
}

}  // namespace rad::bake
