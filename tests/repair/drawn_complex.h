// Complexes drawn by hand, in pitches.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "repair/complex.h"

namespace rad::tests {

class ComplexSketch {
 public:
  explicit ComplexSketch(double tolerance) : complex(tolerance) {}

  /// The point at a place; a new one where there is none.
  repair::PointId point(const geom::LatticePoint& place) {
    for (; known_ < complex.point_count(); ++known_) ids_.try_emplace(complex.point(known_), known_);
    const auto found = ids_.find(place);
    return found == ids_.end() ? complex.add_point(place) : found->second;
  }

  repair::ClusterId plane(const geom::dvec3& normal, const geom::LatticePoint& through = {}) {
    return complex.add_cluster(repair::Plane(normal, through), 1);
  }

  void draw(const std::vector<geom::LatticePoint>& ring, repair::PieceId piece) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const repair::PointId from = point(ring[i]), to = point(ring[(i + 1) % ring.size()]);
      complex.toggle(repair::edge_key(from, to), repair::Item::piece(piece));
    }
  }

  /// A piece with this outline, its front along the cluster's normal.
  repair::PieceId piece(repair::ClusterId cluster, const std::vector<geom::LatticePoint>& ring) {
    const auto rank = static_cast<std::uint32_t>(complex.pieces().size());
    const repair::PieceId id = complex.add_piece({cluster, true, rank, rank});
    draw(ring, id);
    return id;
  }

  /// Whether the edge between two places is there and carries the item.
  [[nodiscard]] bool carries(const geom::LatticePoint& a, const geom::LatticePoint& b, repair::Item item) {
    const auto items = complex.items(repair::edge_key(point(a), point(b)));
    return std::find(items.begin(), items.end(), item) != items.end();
  }

  repair::Complex complex;

 private:
  std::map<geom::LatticePoint, repair::PointId> ids_;
  repair::PointId known_ = 0;  ///< points below this are in ids_
};

/// By brute force over all points and edges: how many points lie
/// within T of an edge that they do not end.
inline std::size_t points_on_edges(const repair::Complex& complex) {
  std::size_t count = 0;
  for (const repair::EdgeKey edge : complex.edges()) {
    const auto [a, b] = repair::ends_of(edge);
    for (repair::PointId id = 0; id < complex.point_count(); ++id) {
      if (id == a || id == b || !complex.live(id)) continue;
      if (geom::distance_to_segment(complex.place(id), complex.place(a), complex.place(b)) <= complex.tolerance()) {
        ++count;
      }
    }
  }
  return count;
}

/// Pairs of edges of one cluster that cross in its projection.
inline std::size_t crossings(const repair::Complex& complex) {
  std::size_t count = 0;
  for (const repair::Cluster& cluster : complex.clusters()) {
    const std::vector<repair::EdgeKey> edges = cluster.sorted_edges();
    const auto flat = [&](repair::PointId id) { return cluster.plane.project(complex.point(id)); };
    const auto side = [&](repair::EdgeKey line, repair::PointId id) {
      const auto [a, b] = repair::ends_of(line);
      return static_cast<int>(geom::orient2d(flat(a), flat(b), flat(id)));
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto [a, b] = repair::ends_of(edges[i]);
        const auto [c, d] = repair::ends_of(edges[j]);
        if (side(edges[i], c) * side(edges[i], d) < 0 && side(edges[j], a) * side(edges[j], b) < 0) ++count;
      }
    }
  }
  return count;
}

}  // namespace rad::tests
