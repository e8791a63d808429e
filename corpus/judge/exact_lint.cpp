#include "corpus/judge/exact_lint.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "corpus/judge/exact_meeting.h"

namespace rad::corpus {
namespace {

using geom::dvec3;
using geom::LatticePoint;

constexpr double kSameCosine = 0.999;      // as the acceptance of repair sees near-coplanar faces: 2.6 degrees
constexpr double kOppositeCosine = -0.99;  // 8 degrees
// Points over the ends of an edge are no t-vertices; the ends are a little longer than the tolerance, so that asking at
// a tolerance just below T agrees with the lint, which has the ends at T.
constexpr double kEndMargin = 1.05;

std::string text(const LatticePoint& p) {
  return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
}

struct Placed {
  std::array<std::uint32_t, 3> ids;
  TriangleCorners corners;
  std::array<dvec3, 3> places;
  dvec3 low, high;
  dvec3 normal;  // unit
};

class BruteForce {
 public:
  BruteForce(const LatticeTriangles& set, double tolerance) : set_(set), tolerance_(tolerance) {
    for (const auto& corners : set.corners) place(corners);
  }

  ExactCounts run() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      for (std::size_t j = i + 1; j < placed_.size(); ++j) judge_pair(placed_[i], placed_[j]);
    }
    for (const Placed& t : placed_) {
      const auto covers = [&](const Placed& other) { return &other != &t && lies_over(t, other); };
      if (std::ranges::any_of(placed_, covers)) count(counts_.overlaps, "overlap", t.corners[0]);
    }
    judge_edges();
    return std::move(counts_);
  }

 private:
  void place(const std::array<std::uint32_t, 3>& ids) {
    Placed t;
    t.ids = ids;
    for (std::size_t i = 0; i < 3; ++i) {
      t.corners[i] = set_.points[ids[i]];
      t.places[i] = geom::as_vector(t.corners[i]);
    }
    if (has_no_area(t.corners)) return count(counts_.degenerate, "degenerate", t.corners[0]);
    t.low = glm::min(t.places[0], glm::min(t.places[1], t.places[2]));
    t.high = glm::max(t.places[0], glm::max(t.places[1], t.places[2]));
    t.normal = glm::normalize(glm::cross(t.places[1] - t.places[0], t.places[2] - t.places[0]));
    placed_.push_back(t);
  }

  void count(std::size_t& kind, const char* name, const LatticePoint& where) {
    if (counts_.first.empty()) counts_.first = std::string(name) + " at " + text(where);
    ++kind;
  }

  static std::size_t common_corners(const Placed& a, const Placed& b) {
    const auto shared = [&](const LatticePoint& p) { return std::ranges::find(b.corners, p) != b.corners.end(); };
    return static_cast<std::size_t>(std::ranges::count_if(a.corners, shared));
  }

  static bool boxes_meet(const Placed& a, const Placed& b, double gap) {
    for (int axis = 0; axis < 3; ++axis) {
      if (a.low[axis] > b.high[axis] + gap || b.low[axis] > a.high[axis] + gap) return false;
    }
    return true;
  }

  [[nodiscard]] bool in_band_of(const Placed& a, const Placed& plane) const {
    return std::ranges::all_of(
        a.places, [&](const dvec3& p) { return std::abs(glm::dot(plane.normal, p - plane.places[0])) <= tolerance_; });
  }
  [[nodiscard]] bool back_to_back(const Placed& a, const Placed& b) const {
    return glm::dot(a.normal, b.normal) <= kOppositeCosine && (in_band_of(a, b) || in_band_of(b, a));
  }

  void judge_pair(const Placed& a, const Placed& b) {
    if (!boxes_meet(a, b, 0)) return;
    if (common_corners(a, b) == 3) {
      if (glm::dot(a.normal, b.normal) > 0) count(counts_.duplicates, "duplicate", a.corners[0]);
    } else if (meet_improperly(a.corners, b.corners) && !back_to_back(a, b)) {
      count(counts_.intersections, "intersection", a.corners[0]);
    }
  }

  // Whether the middle of `t` has its foot inside `other`, within the tolerance.
  [[nodiscard]] bool lies_over(const Placed& t, const Placed& other) const {
    if (glm::dot(t.normal, other.normal) < kSameCosine || !boxes_meet(t, other, tolerance_)) return false;
    const dvec3 middle = (t.places[0] + t.places[1] + t.places[2]) / 3.0;
    if (std::abs(glm::dot(other.normal, middle - other.places[0])) > tolerance_) return false;
    if (common_corners(t, other) == 3) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3 &from = other.places[i], &to = other.places[(i + 1) % 3];
      if (glm::dot(glm::cross(to - from, middle - from), other.normal) <= 0) return false;
    }
    return true;
  }

  void judge_edges() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges;
    std::vector<std::vector<std::size_t>> at_point(set_.points.size());
    for (std::size_t id = 0; id < placed_.size(); ++id) {
      const auto& corners = placed_[id].ids;
      for (std::size_t i = 0; i < 3; ++i) {
        edges[std::minmax(corners[i], corners[(i + 1) % 3])].push_back(id);
        at_point[corners[i]].push_back(id);
      }
    }
    for (const auto& [edge, users] : edges) {
      for (std::uint32_t point = 0; point < set_.points.size(); ++point) {
        if (point == edge.first || point == edge.second || at_point[point].empty()) continue;
        if (!near_inside(point, edge)) continue;
        if (!explained(users, at_point[point])) count(counts_.t_vertices, "t-vertex", set_.points[point]);
      }
    }
  }

  [[nodiscard]] bool near_inside(std::uint32_t point, const std::pair<std::uint32_t, std::uint32_t>& edge) const {
    const dvec3 p = geom::as_vector(set_.points[point]), a = geom::as_vector(set_.points[edge.first]);
    const dvec3 along = geom::as_vector(set_.points[edge.second]) - a;
    const double length = glm::length(along), reach = glm::dot(p - a, along) / length;
    const double margin = kEndMargin * tolerance_;
    if (reach <= margin || reach >= length - margin) return false;
    return glm::length(p - a - along * (reach / length)) <= tolerance_;
  }

  // A contact back to back is one where all faces at the edge and all at the point are of that contact.
  [[nodiscard]] bool explained(const std::vector<std::size_t>& at_edge,
                               const std::vector<std::size_t>& at_point) const {
    bool opposite = false;
    for (const std::size_t e : at_edge) {
      for (const std::size_t p : at_point) {
        if (back_to_back(placed_[e], placed_[p])) {
          opposite = true;
        } else if (glm::dot(placed_[e].normal, placed_[p].normal) > -kOppositeCosine &&
                   in_band_of(placed_[p], placed_[e])) {
          return false;
        }
      }
    }
    return opposite;
  }

  const LatticeTriangles& set_;
  double tolerance_;
  std::vector<Placed> placed_;
  ExactCounts counts_;
};

}  // namespace

std::optional<LatticeTriangles> lattice_triangles(const scene::Scene& scene, const geom::Lattice& lattice) {
  LatticeTriangles result;
  std::map<LatticePoint, std::uint32_t> ids;
  for (const scene::Face& face : scene.faces) {
    if (face.loop_count != 1 || scene.loops[face.first_loop].count != 3) return std::nullopt;
    auto& corners = result.corners.emplace_back();
    std::size_t i = 0;
    for (const scene::VertexId id : scene.corners_of(scene.loops[face.first_loop])) {
      const LatticePoint point = lattice.nearest(scene.vertices[id]);
      if (lattice.position(point) != scene.vertices[id]) return std::nullopt;
      const auto [entry, fresh] = ids.try_emplace(point, static_cast<std::uint32_t>(ids.size()));
      if (fresh) result.points.push_back(point);
      corners[i++] = entry->second;
    }
  }
  return result;
}

ExactCounts exact_lint(const LatticeTriangles& triangles, double tolerance) {
  return BruteForce(triangles, tolerance).run();
}

}  // namespace rad::corpus
