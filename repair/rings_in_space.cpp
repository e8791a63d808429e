#include "repair/rings_in_space.h"

#include <glm/geometric.hpp>
#include <limits>

#include "repair/distance.h"

namespace rad::repair {
namespace {

using geom::LatticePoint;

/// The least sum of areas over corners first…last of a ring, and the corner that its triangle at first–last ends in.
struct Part {
  double area = 0;
  std::uint32_t middle = 0;
};

class LeastArea {
 public:
  explicit LeastArea(std::span<const LatticePoint> ring) : n_(static_cast<std::uint32_t>(ring.size())) {
    for (const LatticePoint& p : ring) place_.push_back(geom::as_vector(p));
    parts_.resize(std::size_t{n_} * n_);
    for (std::uint32_t width = 2; width < n_; ++width) {
      for (std::uint32_t first = 0; first + width < n_; ++first) divide(first, first + width);
    }
  }

  void collect(std::uint32_t first, std::uint32_t last, std::vector<std::array<std::uint32_t, 3>>& out) const {
    if (last < first + 2) return;
    const std::uint32_t middle = parts_[at(first, last)].middle;
    out.push_back({first, middle, last});
    collect(first, middle, out);
    collect(middle, last, out);
  }

 private:
  [[nodiscard]] std::size_t at(std::uint32_t first, std::uint32_t last) const { return std::size_t{first} * n_ + last; }

  void divide(std::uint32_t first, std::uint32_t last) {
    Part best{std::numeric_limits<double>::infinity(), first + 1};
    const dvec3 chord = place_[last] - place_[first];
    for (std::uint32_t middle = first + 1; middle < last; ++middle) {
      const double area = parts_[at(first, middle)].area + parts_[at(middle, last)].area +
                          glm::length(glm::cross(chord, place_[middle] - place_[first])) / 2;
      if (area < best.area) best = {area, middle};
    }
    parts_[at(first, last)] = best;
  }

  std::uint32_t n_;
  std::vector<dvec3> place_;
  std::vector<Part> parts_;
};

}  // namespace

bool meets_itself(std::span<const LatticePoint> ring, std::int64_t tolerance) {
  const std::size_t n = ring.size();
  const auto edge = [&](std::size_t i) {
    return std::array{geom::as_vector(ring[i]), geom::as_vector(ring[(i + 1) % n])};
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      const auto [on_i, on_j] = nearest_of_segments(edge(i), edge(j));
      if (glm::distance(on_i, on_j) <= static_cast<double>(tolerance)) return true;
    }
  }
  return false;
}

std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const LatticePoint> ring) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (ring.size() >= 3) LeastArea(ring).collect(0, static_cast<std::uint32_t>(ring.size()) - 1, triangles);
  return triangles;
}

}  // namespace rad::repair
