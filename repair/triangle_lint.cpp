#include "repair/triangle_lint.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "geom/box_tree.h"
#include "geom/planar_mesh.h"
#include "geom/triangle_meeting.h"

namespace rad::repair {
namespace {

// Opposite within 8°; nearly parallel within 2.6°, as lint has it (geom::kParallelCosine).
constexpr double kOppositeCosine = -0.99;
constexpr double kParallelCosine = 0.999;
// Inside these shares of T the lint of the written file sees nothing, whichever way its numbers are rounded.
constexpr double kContactShare = 0.99;
constexpr double kEdgeEndShare = 0.998;

using geom::LatticeBox;

class Linter {
 public:
  Linter(const TriangleSet& set, std::int64_t tolerance)
      : set_(set),
        triangles_(set.triangles),
        tolerance_(tolerance),
        width_(static_cast<double>(tolerance)),
        tree_(boxes()) {
    normals_.reserve(triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const auto v = corners(i);
      normals_.push_back(glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0])));
    }
  }

  std::vector<Violation> run() {
    find_intersections();
    find_near_coplanar();
    find_points_on_edges();
    find_thin_triangles();
    std::vector<Violation> all;
    for (const auto& part : found_) all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  [[nodiscard]] const LatticePoint& point(PointId id) const { return set_.points[id]; }
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(set_.points[id]); }
  [[nodiscard]] std::array<LatticePoint, 3> points(std::uint32_t i) const {
    const auto& ids = triangles_[i].points;
    return {point(ids[0]), point(ids[1]), point(ids[2])};
  }
  [[nodiscard]] std::array<dvec3, 3> corners(std::uint32_t i) const {
    const auto& ids = triangles_[i].points;
    return {place(ids[0]), place(ids[1]), place(ids[2])};
  }
  [[nodiscard]] std::vector<LatticeBox> boxes() const {
    std::vector<LatticeBox> list;
    list.reserve(triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) list.push_back(geom::box_of(points(i)));
    return list;
  }
  [[nodiscard]] double height(std::uint32_t over, const dvec3& at) const {
    return glm::dot(at - place(triangles_[over].points[0]), normals_[over]);
  }
  [[nodiscard]] bool lies_on(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::all_of(triangles_[a].points,
                               [&](PointId id) { return std::abs(height(b, place(id))) <= kContactShare * width_; });
  }
  [[nodiscard]] bool opposite_contact(std::uint32_t a, std::uint32_t b) const {
    return glm::dot(normals_[a], normals_[b]) <= kOppositeCosine && lies_on(a, b) && lies_on(b, a);
  }
  // Triangles of one plane map do not overlap in projection, so they cannot meet in space.
  [[nodiscard]] bool apart_by_construction(std::uint32_t a, std::uint32_t b) const {
    const ClusterId cluster = triangles_[a].cluster;
    return cluster == triangles_[b].cluster && (set_.folded.empty() || !set_.folded[cluster]);
  }

  template <typename Body>
  void for_all(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
      auto& found = found_.local();
      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i, found);
    });
  }

  void find_intersections() {
    for_all(triangles_.size(), [&](std::size_t slot, std::vector<Violation>& found) {
      tree_.for_each_later_meeting(static_cast<std::uint32_t>(slot), [&](std::uint32_t x, std::uint32_t y) {
        const auto [a, b] = std::minmax(x, y);
        if (opposite_contact(a, b) || apart_by_construction(a, b)) return;
        if (geom::meet_beyond_shared_corners(points(a), points(b))) {
          found.push_back({ViolationKind::Intersection, a, b, 0});
        }
      });
    });
  }

  // The middle of `a` lies within T of `b` and over its open inside.
  [[nodiscard]] bool middle_on(std::uint32_t a, std::uint32_t b) const {
    if (glm::dot(normals_[a], normals_[b]) < kParallelCosine) return false;
    const auto shared = std::ranges::count_if(triangles_[a].points, [&](PointId id) { return triangles_[b].has(id); });
    if (shared == 3) return false;
    const auto own = corners(a);
    const dvec3 middle = (own[0] + own[1] + own[2]) / 3.0;
    const double away = height(b, middle);
    if (std::abs(away) > width_) return false;
    const dvec3 foot = middle - away * normals_[b];
    const auto v = corners(b);
    for (int i = 0; i < 3; ++i) {
      if (glm::dot(glm::cross(v[(i + 1) % 3] - v[i], foot - v[i]), normals_[b]) <= 0) return false;
    }
    return true;
  }

  void find_near_coplanar() {
    for_all(triangles_.size(), [&](std::size_t i, std::vector<Violation>& found) {
      const auto a = static_cast<std::uint32_t>(i);
      const auto v = corners(a);
      const dvec3 middle = (v[0] + v[1] + v[2]) / 3.0;
      std::uint32_t first = geom::kNoTriangle;
      tree_.for_each_near_segment(middle, middle, width_, [&](std::uint32_t b) {
        if (b != a && b < first && middle_on(a, b)) first = b;
      });
      if (first != geom::kNoTriangle) found.push_back({ViolationKind::NearCoplanar, a, first, 0});
    });
  }

  struct EdgeUse {
    EdgeKey edge = 0;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;
    friend constexpr auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
  };

  void gather_edges_and_points() {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        edges_.push_back({edge_key(triangles_[i].points[k], triangles_[i].points[(k + 1) % 3]), i, k});
        used_.push_back(triangles_[i].points[k]);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    std::sort(used_.begin(), used_.end());
    used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  }

  void find_points_on_edges() {
    gather_edges_and_points();
    std::vector<LatticeBox> places;
    places.reserve(used_.size());
    for (const PointId id : used_) places.push_back(geom::box_of(std::span(&point(id), 1)));
    const geom::BoxTree points(std::move(places));
    for_all(edges_.size(), [&](std::size_t use, std::vector<Violation>& found) {
      if (use > 0 && edges_[use].edge == edges_[use - 1].edge) return;
      const auto [a, b] = ends_of(edges_[use].edge);
      const LatticePoint &from = point(a), &to = point(b);
      const double length = glm::distance(place(a), place(b)), end = kEdgeEndShare * width_;
      points.for_each_near_segment(place(a), place(b), width_, [&](std::uint32_t at) {
        const PointId id = used_[at];
        if (id == a || id == b || !geom::point_within_segment(point(id), from, to, tolerance_)) return;
        const double along = glm::dot(place(id) - place(a), place(b) - place(a));
        if (along / length <= end || length - along / length <= end) return;
        found.push_back({ViolationKind::PointOnEdge, edges_[use].triangle, edges_[use].corner, id});
      });
    });
  }

  // A triangle nowhere thicker than T (RL007): its apex is on its longest edge, be it at the end of that.
  void find_thin_triangles() {
    for_all(triangles_.size(), [&](std::size_t i, std::vector<Violation>& found) {
      const auto& ids = triangles_[i].points;
      std::uint32_t longest = 0;
      const auto length = [&](std::uint32_t k) {
        return geom::squared_distance(point(ids[k]), point(ids[(k + 1) % 3]));
      };
      for (const std::uint32_t k : {1u, 2u}) {
        if (length(k) > length(longest)) longest = k;
      }
      const PointId apex = ids[(longest + 2) % 3];
      if (!geom::point_within_segment(point(apex), point(ids[longest]), point(ids[(longest + 1) % 3]), tolerance_))
        return;
      found.push_back({ViolationKind::PointOnEdge, static_cast<std::uint32_t>(i), longest, apex});
    });
  }

  const TriangleSet& set_;
  std::span<const Triangle> triangles_;
  std::int64_t tolerance_;
  double width_;
  geom::BoxTree tree_;
  std::vector<dvec3> normals_;
  std::vector<EdgeUse> edges_;  ///< ascending
  std::vector<PointId> used_;   ///< ascending
  tbb::enumerable_thread_specific<std::vector<Violation>> found_;
};

}  // namespace

std::vector<Violation> lint_triangles(const TriangleSet& set, std::int64_t tolerance) {
  return Linter(set, tolerance).run();
}

}  // namespace rad::repair
