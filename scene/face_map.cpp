#include "scene/face_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "geom/constrained_triangulation.h"
#include "scene/triangle_shares.h"

namespace rad::scene {
namespace {

using geom::LatticePoint;

bool precedes(const dvec3& a, const dvec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Exact until the end, so that it does not matter where a loop starts.
dvec3 newell_normal(const Scene& scene, const Loop& loop, const geom::Lattice& lattice) {
  const auto corners = scene.corners_of(loop);
  std::array<geom::Int128, 3> sum{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const LatticePoint p = lattice.nearest(scene.vertices[corners[i]]);
    const LatticePoint q = lattice.nearest(scene.vertices[corners[(i + 1) % corners.size()]]);
    sum[0] += geom::Int128{p.y} * q.z - geom::Int128{p.z} * q.y;
    sum[1] += geom::Int128{p.z} * q.x - geom::Int128{p.x} * q.z;
    sum[2] += geom::Int128{p.x} * q.y - geom::Int128{p.y} * q.x;
  }
  return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

int largest_axis(const dvec3& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

/// The rings of a face on the lattice, seen along an axis.
class FlatRings {
 public:
  FlatRings(const Scene& scene, const Face& face, const geom::Lattice& lattice, int axis) {
    std::map<LatticePoint, std::uint32_t> index_of;
    const auto point_at = [&](CornerId corner) { return lattice.nearest(scene.vertices[scene.corners[corner]]); };
    for (const Loop& loop : scene.loops_of(face)) {
      for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) index_of[point_at(corner)] = 0;
    }
    for (auto& [point, index] : index_of) {
      index = static_cast<std::uint32_t>(points_.size());
      points_.push_back(geom::project(point, axis));
    }
    corner_of_.resize(points_.size());
    for (const Loop& loop : scene.loops_of(face)) {
      std::vector<std::uint32_t> ring;
      for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) {
        ring.push_back(index_of[point_at(corner)]);
        corner_of_[ring.back()] = corner;
      }
      add_ring(std::move(ring));
    }
  }

  /// None where the rings cross, or points stand above each other: such a face has no planar inside.
  [[nodiscard]] std::vector<std::array<CornerId, 3>> triangles() const {
    std::vector<geom::PlanarPoint> sorted = points_;
    std::sort(sorted.begin(), sorted.end());
    if (rings_.empty() || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return {};
    std::vector<std::array<CornerId, 3>> triangles;
    for (const auto& [corners, boundary] : geom::triangulate_rings(points_, rings_)) {
      triangles.push_back({corner_of_[corners[0]], corner_of_[corners[1]], corner_of_[corners[2]]});
    }
    return triangles;
  }

 private:
  // Without repeats in a row.
  void add_ring(std::vector<std::uint32_t> ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() >= 3) rings_.push_back(std::move(ring));
  }

  std::vector<geom::PlanarPoint> points_;  ///< distinct
  std::vector<CornerId> corner_of_;        ///< per point
  std::vector<std::vector<std::uint32_t>> rings_;
};

}  // namespace

FaceMap::FaceMap(const Scene& scene, const Face& face, const geom::Lattice& lattice) {
  const Loop& outer = scene.loops[face.first_loop];
  normal_ = newell_normal(scene, outer, lattice);
  if (face.loop_count == 1 && outer.count == 3) {
    add_triangle(scene, {outer.first, outer.first + 1, outer.first + 2});
    return;
  }
  const FlatRings flat(scene, face, lattice, largest_axis(normal_));
  for (const auto& corners : flat.triangles()) add_triangle(scene, corners);
  if (triangles_.empty()) add_fan(scene, outer);
}

void FaceMap::add_fan(const Scene& scene, const Loop& outer) {
  for (std::uint32_t i = 2; i < outer.count; ++i) {
    add_triangle(scene, {outer.first, outer.first + i - 1, outer.first + i});
  }
}

// In an order of space, so that sums round alike wherever a file starts a loop.
void FaceMap::add_triangle(const Scene& scene, std::array<CornerId, 3> corners) {
  const auto place_of = [&](CornerId corner) -> const dvec3& { return scene.vertices[scene.corners[corner]]; };
  std::sort(corners.begin(), corners.end(), [&](CornerId a, CornerId b) { return precedes(place_of(a), place_of(b)); });
  const std::array<dvec3, 3> place{place_of(corners[0]), place_of(corners[1]), place_of(corners[2])};
  triangles_.push_back({corners, place, glm::min(place[0], glm::min(place[1], place[2])),
                        glm::max(place[0], glm::max(place[1], place[2]))});
}

FacePlace FaceMap::nearest(const dvec3& point) const {
  FacePlace best;
  const Triangle* chosen = nullptr;
  double least = 0;
  for (const Triangle& triangle : triangles_) {
    const double at_least = glm::distance(glm::clamp(point, triangle.low, triangle.high), point);
    if (chosen != nullptr && at_least > least) continue;
    const std::array<double, 3> share = nearest_shares(triangle.place, point);
    const double distance = glm::distance(blend(triangle.place, share), point);
    const bool better =
        chosen == nullptr || distance < least ||
        (distance == least && std::ranges::lexicographical_compare(triangle.place, chosen->place, precedes));
    if (!better) continue;
    chosen = &triangle;
    least = distance;
    best = {triangle.corner, share};
  }
  return best;
}

}  // namespace rad::scene
