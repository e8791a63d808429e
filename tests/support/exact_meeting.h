// How two triangles meet in exact arithmetic and without any tolerance: the judge of the judge.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <ostream>
#include <vector>

#include "geom/vec.h"

namespace rad::tests {

enum class Meeting : std::uint8_t {
  Apart,
  CommonVertex,    ///< in a point that is a corner of both
  VertexOnEdge,    ///< in a point that is a corner of one and inside an edge of the other
  AlongBothEdges,  ///< along a segment that lies on an edge of each
  PointInside,     ///< in any other point: a corner in the inside, or two edges that cross
  AlongOneEdge,    ///< along a segment that lies on an edge of one only
  Through,         ///< along a segment that lies on an edge of neither
  Area,
};

inline std::ostream& operator<<(std::ostream& out, Meeting meeting) {
  constexpr std::array kNames{"apart",        "common vertex",  "vertex on edge", "along both edges",
                              "point inside", "along one edge", "through",        "area"};
  return out << kNames[static_cast<std::size_t>(meeting)];
}

class ExactTriangle {
 public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Segment = Kernel::Segment_3;

  explicit ExactTriangle(const std::array<geom::LatticePoint, 3>& points)
      : corners_{exact(points[0]), exact(points[1]), exact(points[2])} {}

  [[nodiscard]] Kernel::Triangle_3 triangle() const { return {corners_[0], corners_[1], corners_[2]}; }
  [[nodiscard]] bool has_corner(const Point& p) const {
    return corners_[0] == p || corners_[1] == p || corners_[2] == p;
  }
  /// Whether both points lie on one and the same edge.
  [[nodiscard]] bool has_on_edge(const Point& p, const Point& q) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Segment edge(corners_[i], corners_[(i + 1) % 3]);
      if (edge.has_on(p) && edge.has_on(q)) return true;
    }
    return false;
  }

 private:
  static Point exact(const geom::LatticePoint& p) { return {p.x, p.y, p.z}; }

  std::array<Point, 3> corners_;
};

inline Meeting meeting_in(const ExactTriangle& a, const ExactTriangle& b, const ExactTriangle::Point& p) {
  if (a.has_corner(p) && b.has_corner(p)) return Meeting::CommonVertex;
  const bool vertex_on_edge = (a.has_corner(p) && b.has_on_edge(p, p)) || (b.has_corner(p) && a.has_on_edge(p, p));
  return vertex_on_edge ? Meeting::VertexOnEdge : Meeting::PointInside;
}

inline Meeting meeting_along(const ExactTriangle& a, const ExactTriangle& b, const ExactTriangle::Segment& segment) {
  const bool along_a = a.has_on_edge(segment.source(), segment.target());
  const bool along_b = b.has_on_edge(segment.source(), segment.target());
  if (along_a && along_b) return Meeting::AlongBothEdges;
  return along_a || along_b ? Meeting::AlongOneEdge : Meeting::Through;
}

/// Both triangles must have area.
inline Meeting exact_meeting(const std::array<geom::LatticePoint, 3>& a, const std::array<geom::LatticePoint, 3>& b) {
  const ExactTriangle exact_a(a), exact_b(b);
  const auto common = CGAL::intersection(exact_a.triangle(), exact_b.triangle());
  if (!common) return Meeting::Apart;
  if (const auto* point = boost::get<ExactTriangle::Point>(&*common)) return meeting_in(exact_a, exact_b, *point);
  if (const auto* segment = boost::get<ExactTriangle::Segment>(&*common)) {
    return meeting_along(exact_a, exact_b, *segment);
  }
  return Meeting::Area;
}

}  // namespace rad::tests
