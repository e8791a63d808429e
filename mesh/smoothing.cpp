#include "mesh/smoothing.h"

#include <algorithm>
#include <cmath>

#include "mesh/face_frame.h"

namespace rad::mesh {
namespace {

using geom::PlanePoint;

double doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Smoother {
 public:
  Smoother(std::span<const LinkedTriangle> triangles, const FaceFrame& frame, double least_height, double longest,
           FacePoints& points)
      : triangles_(triangles), frame_(frame), least_height_(least_height), longest_(longest), points_(points) {
    first_.assign(points.plane.size() + 1, 0);
    for (const LinkedTriangle& triangle : triangles) {
      for (const std::uint32_t corner : triangle.corner) ++first_[corner];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : first_) entry = sum += entry;
    around_.resize(sum);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (const std::uint32_t corner : triangle_at(t)) around_[--first_[corner]] = t;
    }
  }

  bool move(std::uint32_t point) {
    const std::span<const std::uint32_t> star =
        std::span(around_).subspan(first_[point], first_[point + 1] - first_[point]);
    if (star.empty()) return false;
    PlanePoint sum{0, 0};
    double weight = 0;
    for (const std::uint32_t t : star) {
      const auto& [a, b, c] = triangle_at(t);
      const PlanePoint &p = points_.plane[a], &q = points_.plane[b], &r = points_.plane[c];
      const double area = doubled_area(p, q, r);
      sum = {sum.x + area * (p.x + q.x + r.x) / 3, sum.y + area * (p.y + q.y + r.y) / 3};
      weight += area;
    }
    return try_place(point, star, frame_.nearest({sum.x / weight, sum.y / weight}));
  }

 private:
  [[nodiscard]] const std::array<std::uint32_t, 3>& triangle_at(std::uint32_t t) const { return triangles_[t].corner; }

  bool try_place(std::uint32_t point, std::span<const std::uint32_t> star, const geom::LatticePoint& place) {
    const geom::LatticePoint old = points_.lattice[point];
    if (place == old) return false;
    const double before = worst(star);
    set(point, place);
    if (fits(star) && worst(star) > before) return true;
    set(point, old);
    return false;
  }

  void set(std::uint32_t point, const geom::LatticePoint& place) {
    points_.lattice[point] = place;
    points_.flat[point] = frame_.flat(place);
    points_.plane[point] = frame_.in_plane(place);
  }

  [[nodiscard]] double worst(std::span<const std::uint32_t> star) const {
    double least = 1;
    for (const std::uint32_t t : star) {
      const auto& [a, b, c] = triangle_at(t);
      const std::array<PlanePoint, 3> place{points_.plane[a], points_.plane[b], points_.plane[c]};
      least = std::min(least, geom::scaled_shape(place));
    }
    return least;
  }

  // Whether every triangle turns left, exactly, and keeps the height and the length.
  [[nodiscard]] bool fits(std::span<const std::uint32_t> star) const {
    return std::ranges::all_of(star, [&](std::uint32_t t) {
      const auto& [a, b, c] = triangle_at(t);
      if (geom::orient2d(points_.flat[a], points_.flat[b], points_.flat[c]) != geom::Sign::Positive) return false;
      const PlanePoint &p = points_.plane[a], &q = points_.plane[b], &r = points_.plane[c];
      const double longest = std::max(
          {std::hypot(q.x - p.x, q.y - p.y), std::hypot(r.x - q.x, r.y - q.y), std::hypot(p.x - r.x, p.y - r.y)});
      return doubled_area(p, q, r) > least_height_ * longest && longest <= longest_;
    });
  }

  std::span<const LinkedTriangle> triangles_;
  const FaceFrame& frame_;
  double least_height_;
  double longest_;
  FacePoints& points_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> around_;  ///< triangles at each point
};

}  // namespace

bool smooth(std::span<const LinkedTriangle> triangles, const std::vector<bool>& free, const FaceFrame& frame,
            double least_height, double longest, FacePoints& points) {
  Smoother smoother(triangles, frame, least_height, longest, points);
  bool moved = false;
  for (std::uint32_t point = 0; point < free.size(); ++point) {
    if (free[point]) moved |= smoother.move(point);
  }
  return moved;
}

}  // namespace rad::mesh
