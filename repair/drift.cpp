#include "repair/drift.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geom/box_tree.h"
#include "repair/distance.h"

namespace rad::repair {
namespace {

// What draws a surface farther than it may lies within this of where that shows, T: twice as far as it may.
constexpr double kAroundPlace = 2 * kFarthestSurface;

using Corners = std::array<LatticePoint, 3>;
using Places = std::array<dvec3, 3>;

Places places_of(const Corners& corners) {
  return {geom::as_vector(corners[0]), geom::as_vector(corners[1]), geom::as_vector(corners[2])};
}

/// Triangles that a place may be near to.
class Surfaces {
 public:
  explicit Surfaces(std::vector<Corners> triangles) : triangles_(std::move(triangles)), tree_(boxes()) {}

  /// Calls visit(i) for those within `reach` of the place.
  template <typename Visit>
  void for_each_within(const dvec3& place, double reach, Visit&& visit) const {
    tree_.for_each_near_segment(place, place, reach, [&](std::uint32_t i) {
      if (distance_to_triangle(place, triangles_[i]) <= reach) visit(i);
    });
  }
  /// Whether the place is farther than `reach` from all of them.
  [[nodiscard]] bool is_off(const dvec3& place, double reach) const {
    bool near = false;
    for_each_within(place, reach, [&](std::uint32_t) { near = true; });
    return !near;
  }

 private:
  [[nodiscard]] std::vector<geom::LatticeBox> boxes() const {
    std::vector<geom::LatticeBox> all;
    all.reserve(triangles_.size());
    for (const Corners& corners : triangles_) all.push_back(geom::box_of(corners));
    return all;
  }

  std::vector<Corners> triangles_;
  geom::BoxTree tree_;
};

class Measure {
 public:
  Measure(const Conformed& conformed, const Soup& before, std::int64_t tolerance)
      : conformed_(conformed),
        complex_(*conformed.complex),
        tolerance_(static_cast<double>(tolerance)),
        reach_(kFarthestSurface * static_cast<double>(tolerance)) {
    for (const SoupPiece& piece : before.pieces) {
      if (piece.edge_count == 3) {
        before_.push_back(before.triangle(piece));
        origins_.push_back(before.origins.empty() ? static_cast<std::uint32_t>(origins_.size()) : piece.origin);
      }
      any_rings_ = any_rings_ || piece.edge_count != 3;
    }
    for (const std::uint32_t i : conformed.triangulation.living()) {
      const Triangle& triangle = conformed.triangulation.triangles()[i];
      after_.push_back(corners_of(triangle));
      if (triangle.cluster != kNoCluster) changed_.push_back(i);
    }
  }

  Drift run() {
    // Rings that cross have no triangles to be held against.
    const Surfaces before(before_);
    if (!any_rings_) look_at(changed_.size(), before, [&](std::size_t i) { return of_changed(i); });
    look_at(before_.size(), Surfaces(after_), [&](std::size_t i) { return deep_places(places_of(before_[i])); });
    name_origins(before);
    return total_;
  }

 private:
  [[nodiscard]] Corners corners_of(const Triangle& triangle) const {
    return {complex_.point(triangle.points[0]), complex_.point(triangle.points[1]), complex_.point(triangle.points[2])};
  }

  // Nothing where all of the triangle is near where its own piece was.
  [[nodiscard]] std::vector<dvec3> of_changed(std::size_t i) const {
    const Triangle& triangle = conformed_.triangulation.triangles()[changed_[i]];
    const Places v = places_of(corners_of(triangle));
    const std::uint32_t origin = complex_.pieces()[triangle.winner].origin;
    const bool near = origin != kNoOrigin && std::ranges::all_of(v, [&](const dvec3& p) {
                        return distance_to_triangle(p, complex_.origins()[origin]) <= reach_;
                      });
    if (near) return {};
    return {
        v[0], v[1], v[2], 0.5 * (v[0] + v[1]), 0.5 * (v[1] + v[2]), 0.5 * (v[2] + v[0]), (v[0] + v[1] + v[2]) / 3.0};
  }

  // Of a triangle that is more than T deep somewhere: that place and the middle; of a deep one half way to the corners.
  [[nodiscard]] std::vector<dvec3> deep_places(const Places& v) const {
    const double a = glm::distance(v[1], v[2]), b = glm::distance(v[2], v[0]), c = glm::distance(v[0], v[1]);
    const double twice_area = glm::length(glm::cross(v[1] - v[0], v[2] - v[0]));
    if (!(twice_area > (a + b + c) * tolerance_)) return {};
    const dvec3 incentre = (a * v[0] + b * v[1] + c * v[2]) / (a + b + c);
    std::vector<dvec3> places{incentre, (v[0] + v[1] + v[2]) / 3.0};
    if (twice_area / (a + b + c) <= 2 * tolerance_) return places;
    for (const dvec3& corner : v) places.push_back(0.5 * (incentre + corner));
    return places;
  }

  // All that was around a place: any of it may have been drawn off.
  void name_origins(const Surfaces& before) {
    std::vector<std::uint32_t>& list = total_.origins;
    for (const dvec3& place : off_) {
      before.for_each_within(place, kAroundPlace * tolerance_, [&](std::uint32_t i) { list.push_back(origins_[i]); });
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  template <typename PlacesOf>
  void look_at(std::size_t count, const Surfaces& surfaces, PlacesOf places_of_item) {
    tbb::enumerable_thread_specific<std::vector<dvec3>> found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        for (const dvec3& place : places_of_item(i)) {
          if (surfaces.is_off(place, reach_)) found.local().push_back(place);
        }
      }
    });
    for (const auto& places : found) {
      for (const dvec3& place : places) {
        const auto key = [](const dvec3& p) { return std::array{p.x, p.y, p.z}; };
        if (total_.places == 0 || key(place) < key(total_.first)) total_.first = place;
        ++total_.places;
        off_.push_back(place);
      }
    }
  }

  const Conformed& conformed_;
  const Complex& complex_;
  double tolerance_, reach_;
  bool any_rings_ = false;
  std::vector<Corners> before_, after_;
  std::vector<std::uint32_t> origins_;  ///< of before_
  std::vector<dvec3> off_;              ///< places that are too far
  std::vector<std::uint32_t> changed_;  ///< triangles that are not pieces as they were
  Drift total_;
};

}  // namespace

Drift drift_of(const Conformed& conformed, const Soup& before, std::int64_t tolerance) {
  if (conformed.counts.complex.merges == 0 && conformed.counts.residual.rehomed == 0) return {};
  return Measure(conformed, before, tolerance).run();
}

}  // namespace rad::repair
