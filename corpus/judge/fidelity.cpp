#include "corpus/judge/fidelity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "repair/distance.h"

namespace rad::corpus {
namespace {

using geom::dvec3;

// Steps along each side in the grid of points that are tried besides the deepest one.
constexpr int kSteps = 6;

struct Boxed {
  PlacedTriangle corners;
  dvec3 low, high;

  explicit Boxed(const PlacedTriangle& t)
      : corners(t), low(glm::min(t[0], glm::min(t[1], t[2]))), high(glm::max(t[0], glm::max(t[1], t[2]))) {}

  [[nodiscard]] double box_distance(const dvec3& p) const {
    return glm::length(glm::max(dvec3(0), glm::max(low - p, p - high)));
  }
};

class Distances {
 public:
  Distances(const std::vector<PlacedTriangle>& to, const geom::Box& except)
      : to_(to.begin(), to.end()), except_(except) {}

  /// 0 in the box that does not count.
  [[nodiscard]] double nearest(const dvec3& p) const {
    if (!except_.empty() && p == glm::clamp(p, except_.low, except_.high)) return 0;
    double least = INFINITY;
    for (const Boxed& t : to_) {
      if (t.box_distance(p) < least) least = std::min(least, repair::distance_to_triangle(p, t.corners));
    }
    return least;
  }

 private:
  std::vector<Boxed> to_;
  geom::Box except_;
};

double line_distance(const dvec3& p, const dvec3& a, const dvec3& b) {
  return glm::length(glm::cross(b - a, p - a)) / glm::distance(a, b);
}

double depth_of(const dvec3& p, const PlacedTriangle& t) {
  return std::min({line_distance(p, t[0], t[1]), line_distance(p, t[1], t[2]), line_distance(p, t[2], t[0])});
}

dvec3 deepest_point(const PlacedTriangle& t) {
  const double a = glm::distance(t[1], t[2]), b = glm::distance(t[2], t[0]), c = glm::distance(t[0], t[1]);
  return (a * t[0] + b * t[1] + c * t[2]) / (a + b + c);
}

bool has_area(const PlacedTriangle& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) > 0; }

}  // namespace

double farthest_deep_point(const std::vector<PlacedTriangle>& from, const std::vector<PlacedTriangle>& to, double depth,
                           const geom::Box& except) {
  const Distances distances(to, except);
  double farthest = 0;
  const auto look = [&](const dvec3& p, const PlacedTriangle& t) {
    if (depth_of(p, t) > depth) farthest = std::max(farthest, distances.nearest(p));
  };
  for (const PlacedTriangle& t : from) {
    if (!has_area(t) || !(depth_of(deepest_point(t), t) > depth)) continue;
    look(deepest_point(t), t);
    for (int i = 1; i < kSteps; ++i) {
      for (int j = 1; i + j < kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
        look(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), t);
      }
    }
  }
  return farthest;
}

double farthest_point(const std::vector<PlacedTriangle>& from, const std::vector<PlacedTriangle>& to,
                      const geom::Box& except) {
  const Distances distances(to, except);
  double farthest = 0;
  for (const PlacedTriangle& t : from) {
    for (std::size_t i = 0; i < 3; ++i) {
      farthest = std::max({farthest, distances.nearest(t[i]), distances.nearest((t[i] + t[(i + 1) % 3]) / 2.0)});
    }
    farthest = std::max(farthest, distances.nearest((t[0] + t[1] + t[2]) / 3.0));
  }
  return farthest;
}

}  // namespace rad::corpus
