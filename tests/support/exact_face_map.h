// How the faces of a small scene cut each other, in exact arithmetic: an oracle for the combinatorics of repair.
#pragma once

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <optional>
#include <vector>

#include "geom/vec.h"

namespace rad::tests {

/// A convex planar polygon of lattice points.
class ExactFace {
 public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Number = Kernel::FT;
  using Point3 = Kernel::Point_3;
  using Point2 = Kernel::Point_2;
  using Segment2 = Kernel::Segment_2;

  explicit ExactFace(const std::vector<geom::LatticePoint>& corners) {
    for (const geom::LatticePoint& p : corners) corners_.emplace_back(p.x, p.y, p.z);
    plane_ = Kernel::Plane_3(corners_[0], corners_[1], corners_[2]);
    dropped_ = plane_.c() != 0 ? 2 : plane_.b() != 0 ? 1 : 0;
    for (const Point3& p : corners_) outline_.push_back(flat(p));
    if (area_of(outline_) < 0) std::reverse(outline_.begin(), outline_.end());
  }

  [[nodiscard]] const std::vector<Point3>& corners() const { return corners_; }
  [[nodiscard]] bool is_coplanar(const ExactFace& other) const {
    return std::ranges::all_of(other.corners_, [&](const Point3& p) { return plane_.has_on(p); });
  }
  /// Whether the two lie in one plane and have an area in common.
  [[nodiscard]] bool overlaps(const ExactFace& other) const {
    if (!is_coplanar(other)) return false;
    std::vector<Point2> rest;
    for (const Point3& p : other.corners_) rest.push_back(flat(p));
    for (std::size_t i = 0; i < outline_.size(); ++i) rest = left_of(rest, edge(i));
    return rest.size() >= 3 && area_of(rest) != 0;
  }

  /// What this face and the edges and inside of another have in common, seen in this face: segments or points.
  [[nodiscard]] std::vector<Segment2> marks_of(const ExactFace& other) const {
    std::vector<Segment2> marks;
    for (const Segment2& segment : other.seen_from(*this)) {
      if (const auto inside = clipped(segment)) marks.push_back(*inside);
    }
    return marks;
  }

  [[nodiscard]] Segment2 edge(std::size_t i) const { return {outline_[i], outline_[(i + 1) % outline_.size()]}; }
  [[nodiscard]] std::size_t size() const { return outline_.size(); }

  [[nodiscard]] Point2 flat(const Point3& p) const {
    return dropped_ == 2 ? Point2(p.x(), p.y()) : dropped_ == 1 ? Point2(p.x(), p.z()) : Point2(p.y(), p.z());
  }
  [[nodiscard]] Point3 lifted(const Point2& p) const {
    const Number &a = plane_.a(), &b = plane_.b(), &c = plane_.c(), &d = plane_.d();
    if (dropped_ == 2) return {p.x(), p.y(), -(a * p.x() + b * p.y() + d) / c};
    if (dropped_ == 1) return {p.x(), -(a * p.x() + c * p.y() + d) / b, p.y()};
    return {-(b * p.x() + c * p.y() + d) / a, p.x(), p.y()};
  }

 private:
  static Number area_of(const std::vector<Point2>& ring) {
    Number twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
      twice += p.x() * q.y() - q.x() * p.y();
    }
    return twice / 2;
  }

  static std::vector<Point2> left_of(const std::vector<Point2>& ring, const Segment2& edge) {
    std::vector<Point2> rest;
    const auto side = [&](const Point2& p) { return CGAL::orientation(edge.source(), edge.target(), p); };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if (side(p) >= 0) rest.push_back(p);
      if (side(p) * side(q) < 0) {
        const auto met = CGAL::intersection(Kernel::Line_2(p, q), Kernel::Line_2(edge.source(), edge.target()));
        rest.push_back(boost::get<Point2>(*met));
      }
    }
    return rest;
  }

  // The line in which the plane of `viewer` cuts this face, or its edges where it lies in that plane.
  [[nodiscard]] std::vector<Segment2> seen_from(const ExactFace& viewer) const {
    std::vector<Segment2> all;
    std::vector<Point3> met;
    const bool coplanar = viewer.is_coplanar(*this);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Point3 &p = corners_[i], &q = corners_[(i + 1) % corners_.size()];
      if (coplanar) all.emplace_back(viewer.flat(p), viewer.flat(q));
      if (viewer.plane_.has_on(p)) met.push_back(p);
      if (viewer.plane_.oriented_side(p) * viewer.plane_.oriented_side(q) < 0) {
        met.push_back(boost::get<Point3>(*CGAL::intersection(Kernel::Line_3(p, q), viewer.plane_)));
      }
    }
    if (!coplanar && !met.empty()) all.emplace_back(viewer.flat(met.front()), viewer.flat(met.back()));
    return all;
  }

  // The part of a segment in the closed polygon; of no length where it only touches.
  [[nodiscard]] std::optional<Segment2> clipped(const Segment2& segment) const {
    const auto along = segment.to_vector();
    Number from = 0, to = 1;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const auto side = edge(i).to_vector();
      const auto offset = segment.source() - edge(i).source();
      const Number start = side.x() * offset.y() - side.y() * offset.x();
      const Number slope = side.x() * along.y() - side.y() * along.x();
      if (slope == 0 && start < 0) return std::nullopt;
      if (slope > 0) from = std::max<Number>(from, -start / slope);
      if (slope < 0) to = std::min<Number>(to, -start / slope);
    }
    if (from > to) return std::nullopt;
    return Segment2(segment.source() + from * along, segment.source() + to * along);
  }

  std::vector<Point3> corners_;
  Kernel::Plane_3 plane_;
  int dropped_ = 2;
  std::vector<Point2> outline_;
};

/// The map of one face: its outline, and what all others leave on it.
class ExactFaceMap {
 public:
  using Kernel = ExactFace::Kernel;
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;

  ExactFaceMap(const std::vector<ExactFace>& faces, std::size_t own) : face_(faces[own]) {
    for (std::size_t i = 0; i < face_.size(); ++i) CGAL::insert(map_, face_.edge(i));
    for (std::size_t other = 0; other < faces.size(); ++other) {
      if (other == own) continue;
      bool along = false;
      for (const auto& mark : face_.marks_of(faces[other])) {
        along |= !mark.is_degenerate();
        if (mark.is_degenerate()) {
          CGAL::insert_point(map_, mark.source());
        } else {
          CGAL::insert(map_, mark);
        }
      }
      if (along) neighbours_.push_back(other);
      if (face_.overlaps(faces[other])) overlapping_ = true;
    }
  }

  /// The pieces into which the others cut the face.
  [[nodiscard]] std::size_t cells() const { return map_.number_of_faces() - map_.number_of_unbounded_faces(); }
  /// Faces that meet this one along some length, ascending.
  [[nodiscard]] const std::vector<std::size_t>& neighbours() const { return neighbours_; }
  [[nodiscard]] bool overlapping() const { return overlapping_; }

  /// Rounded.
  [[nodiscard]] std::vector<geom::dvec3> points() const {
    std::vector<geom::dvec3> all;
    for (auto v = map_.vertices_begin(); v != map_.vertices_end(); ++v) all.push_back(rounded(v->point()));
    return all;
  }
  [[nodiscard]] std::vector<std::array<geom::dvec3, 2>> edges() const {
    std::vector<std::array<geom::dvec3, 2>> all;
    for (auto e = map_.edges_begin(); e != map_.edges_end(); ++e) {
      all.push_back({rounded(e->source()->point()), rounded(e->target()->point())});
    }
    return all;
  }

 private:
  [[nodiscard]] geom::dvec3 rounded(const Kernel::Point_2& flat) const {
    const auto p = face_.lifted(flat);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  const ExactFace& face_;
  Arrangement map_;
  std::vector<std::size_t> neighbours_;
  bool overlapping_ = false;
};

}  // namespace rad::tests
