#include "mesh/display_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geom/constrained_triangulation.h"
#include "mesh/element_views.h"
#include "mesh/flat_view.h"

namespace rad::mesh {
namespace {

class Ziplock {
 public:
  explicit Ziplock(const ElementMesh& mesh) : mesh_(mesh) {
    for (NodeId node = 0; node < mesh.node_count(); ++node) {
      display_.vertices.push_back({mesh.points()[mesh.point_of(node)], {node, node}, 0});
    }
  }

  DisplayMesh run() {
    for (const ElementId leaf : mesh_.leaves()) {
      use_patch(mesh_.patch_of(leaf));
      for (const auto pieces = mesh_.anchored(leaf); const Corners& piece : pieces.all()) add_piece(piece);
    }
    return std::move(display_);
  }

 private:
  void use_patch(PatchId patch) {
    const PatchSource& source = mesh_.source(patch);
    view_ = FlatView(source.normal);
    face_ = {{}, 3, patch, source.material, source.object, source.group};
  }

  void add_piece(const Corners& piece) {
    ring_.clear();
    for (std::uint32_t i = 0; i < piece.count; ++i) {
      const NodeId from = piece.node[i], to = piece.node[(i + 1) % piece.count];
      ring_.push_back(from);
      for (const EdgePoint& point : mesh_.edge_points(from, to)) ring_.push_back(vertex_between(from, to, point));
    }
    flat_.clear();
    for (const std::uint32_t vertex : ring_) flat_.push_back(view_.of(display_.vertices[vertex].point));
    if (ring_.size() == 3 || (ring_.size() == 4 && strictly_convex())) {
      add_face(ring_);
    } else {
      add_triangulated();
    }
  }

  // One vertex for both ways along an edge.
  std::uint32_t vertex_between(NodeId from, NodeId to, const EdgePoint& point) {
    const std::array<NodeId, 2> ends{std::min(from, to), std::max(from, to)};
    const auto next = static_cast<std::uint32_t>(display_.vertices.size());
    const auto [entry, added] = between_.try_emplace({ends[0], ends[1], point.point}, next);
    if (added) {
      const double share = from < to ? point.share : 1 - point.share;
      display_.vertices.push_back({mesh_.points()[point.point], ends, share});
    }
    return entry->second;
  }

  // Points are off their plane by up to 0.87 pitches, so a corner that hardly rises over its neighbours may be reflex
  // when it is seen along another normal.
  [[nodiscard]] bool strictly_convex() const {
    constexpr double kLeastRise = 4;  // pitches
    for (std::size_t i = 0; i < 4; ++i) {
      const geom::PlanarPoint &before = flat_[i], &at = flat_[(i + 1) % 4], &after = flat_[(i + 2) % 4];
      const auto u = static_cast<double>(after.u - before.u), v = static_cast<double>(after.v - before.v);
      const auto du = static_cast<double>(at.u - before.u), dv = static_cast<double>(at.v - before.v);
      if (du * v - dv * u <= kLeastRise * std::hypot(u, v)) return false;
    }
    return true;
  }

  void add_triangulated() {
    std::vector<std::uint32_t> loop(ring_.size());
    for (std::uint32_t i = 0; i < loop.size(); ++i) loop[i] = i;
    for (const auto& triangle : geom::triangulate_rings(flat_, std::span(&loop, 1))) {
      add_face(std::array{ring_[triangle.corners[0]], ring_[triangle.corners[1]], ring_[triangle.corners[2]]});
    }
  }

  void add_face(std::span<const std::uint32_t> corners) {
    face_.count = static_cast<std::uint32_t>(corners.size());
    face_.corner = {};
    std::copy(corners.begin(), corners.end(), face_.corner.begin());
    display_.faces.push_back(face_);
  }

  const ElementMesh& mesh_;
  DisplayMesh display_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> between_;  // by the nodes of the edge and the point
  FlatView view_;
  DisplayFace face_;
  std::vector<std::uint32_t> ring_;      // vertices around the piece
  std::vector<geom::PlanarPoint> flat_;  // the same, projected
};

}  // namespace

DisplayMesh display_mesh(const ElementMesh& mesh) { return Ziplock(mesh).run(); }

}  // namespace rad::mesh
