// Soups and complexes drawn by hand, in pitches.
#pragma once

#include <map>
#include <vector>

#include "repair/soup.h"

namespace rad::tests {

/// Triangles on shared points, each a piece and a source face of its own.
class SoupSketch {
 public:
  scene::PointId point(const geom::LatticePoint& place) {
    const auto [entry, added] = ids_.try_emplace(place, static_cast<scene::PointId>(soup_.points.size()));
    if (added) soup_.points.push_back(place);
    return entry->second;
  }

  void triangle(const geom::LatticePoint& a, const geom::LatticePoint& b, const geom::LatticePoint& c) {
    ring({a, b, c});
  }
  void quad(const geom::LatticePoint& a, const geom::LatticePoint& b, const geom::LatticePoint& c,
            const geom::LatticePoint& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  /// One piece of any number of corners.
  void ring(const std::vector<geom::LatticePoint>& places) {
    const auto source = static_cast<scene::FaceId>(soup_.pieces.size());
    soup_.pieces.push_back(
        {static_cast<std::uint32_t>(soup_.edges.size()), static_cast<std::uint32_t>(places.size()), source, source});
    for (std::size_t i = 0; i < places.size(); ++i) {
      const scene::PointId from = point(places[i]);
      soup_.edges.push_back({from, point(places[(i + 1) % places.size()])});
    }
  }

  [[nodiscard]] repair::Soup take() const { return soup_; }

 private:
  repair::Soup soup_;
  std::map<geom::LatticePoint, scene::PointId> ids_;
};

}  // namespace rad::tests
