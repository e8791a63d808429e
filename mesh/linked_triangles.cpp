#include "mesh/linked_triangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rad::mesh {
namespace {

struct EdgeUse {
  std::uint32_t low, high, triangle;
  std::size_t edge;
};

double cotangent(const geom::PlanePoint& apex, const geom::PlanePoint& a, const geom::PlanePoint& b) {
  const double ax = a.x - apex.x, ay = a.y - apex.y, bx = b.x - apex.x, by = b.y - apex.y;
  return (ax * bx + ay * by) / std::abs(ax * by - ay * bx);
}

class Flips {
 public:
  Flips(std::vector<LinkedTriangle>& triangles, std::span<const geom::PlanarPoint> flat,
        std::span<const geom::PlanePoint> plane)
      : triangles_(triangles), flat_(flat), plane_(plane) {}

  std::size_t sweep() {
    std::size_t flips = 0;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        if (!should_flip(t, edge)) continue;
        flip(t, edge);
        ++flips;
      }
    }
    return flips;
  }

 private:
  [[nodiscard]] bool should_flip(std::uint32_t t, std::size_t edge) const {
    const LinkedTriangle& here = triangles_[t];
    if (here.fixed[edge] || here.across[edge] == kNoTriangle) return false;
    const LinkedTriangle& there = triangles_[here.across[edge]];
    const std::uint32_t a = here.corner[edge], b = here.corner[(edge + 1) % 3], c = here.opposite(edge);
    const std::uint32_t d = there.opposite(there.edge_from(b, a));
    // Opposite angles of more than 180° together; the slack keeps rounding from flipping squares to and fro.
    constexpr double kCotangentSlack = 1e-9;
    if (cotangent(plane_[c], plane_[a], plane_[b]) + cotangent(plane_[d], plane_[a], plane_[b]) > -kCotangentSlack) {
      return false;
    }
    return turns_left(a, d, c) && turns_left(d, b, c);
  }

  [[nodiscard]] bool turns_left(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return geom::orient2d(flat_[a], flat_[b], flat_[c]) == geom::Sign::Positive;
  }

  // abc and bad become adc and dbc.
  void flip(std::uint32_t t, std::size_t edge) {
    const std::uint32_t s = triangles_[t].across[edge];
    const LinkedTriangle here = triangles_[t], there = triangles_[s];
    const std::uint32_t a = here.corner[edge], b = here.corner[(edge + 1) % 3], c = here.opposite(edge);
    const std::size_t back = there.edge_from(b, a);
    const std::uint32_t d = there.opposite(back);
    const std::size_t bc = (edge + 1) % 3, ca = (edge + 2) % 3, ad = (back + 1) % 3, db = (back + 2) % 3;
    triangles_[t] = {{a, d, c}, {there.across[ad], s, here.across[ca]}, {there.fixed[ad], false, here.fixed[ca]}};
    triangles_[s] = {{d, b, c}, {there.across[db], here.across[bc], t}, {there.fixed[db], here.fixed[bc], false}};
    relink(there.across[ad], d, a, t);
    relink(here.across[bc], c, b, s);
  }

  void relink(std::uint32_t neighbour, std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    if (neighbour == kNoTriangle) return;
    LinkedTriangle& other = triangles_[neighbour];
    other.across[other.edge_from(from, to)] = triangle;
  }

  std::vector<LinkedTriangle>& triangles_;
  std::span<const geom::PlanarPoint> flat_;
  std::span<const geom::PlanePoint> plane_;
};

}  // namespace

std::vector<LinkedTriangle> linked(std::span<const geom::PolygonTriangle> triangles) {
  std::vector<LinkedTriangle> links(triangles.size());
  std::vector<EdgeUse> uses;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    links[t].corner = triangles[t].corners;
    links[t].fixed = triangles[t].boundary;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = links[t].corner[i], b = links[t].corner[(i + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, i});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (uses[i].low != uses[i - 1].low || uses[i].high != uses[i - 1].high) continue;
    links[uses[i].triangle].across[uses[i].edge] = uses[i - 1].triangle;
    links[uses[i - 1].triangle].across[uses[i - 1].edge] = uses[i].triangle;
  }
  return links;
}

void flip_to_delaunay(std::vector<LinkedTriangle>& triangles, std::span<const geom::PlanarPoint> flat,
                      std::span<const geom::PlanePoint> plane) {
  // A Delaunay triangulation in the projection is a few sweeps from the one in the plane: the projection squeezes by
  // √3 at most. The bound only stops what rounding could otherwise keep going.
  constexpr int kMostSweeps = 64;
  Flips flips(triangles, flat, plane);
  for (int sweep = 0; sweep < kMostSweeps && flips.sweep() > 0; ++sweep) {
  }
}

}  // namespace rad::mesh
