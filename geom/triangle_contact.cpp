#include "geom/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "geom/planar_clip.h"

namespace rad::geom {
namespace {

dvec3 as_vector(const IntVector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Where the edge from `from` to `to` meets the plane; the ends lie on opposite sides.
dvec3 crossing_point(const LatticePoint& from, const LatticePoint& to, const TrianglePlane& plane) {
  const double at_from = static_cast<double>(plane.value(from));
  const double at_to = static_cast<double>(plane.value(to));
  const dvec3 start = as_vector(from);
  return start + (at_from / (at_from - at_to)) * (as_vector(to) - start);
}

struct Chord {
  std::array<dvec3, 3> points;
  std::array<dvec3, 3> feet;  ///< of the points on the plane
  int count = 0;

  void add(const dvec3& point, const dvec3& foot) {
    points[count] = point;
    feet[count++] = foot;
  }
};

// The part of a triangle in the band of the other's plane: a point, or a segment given by its two ends.
Chord chord_of(const LatticeTriangle& triangle, const Sides& sides, const TrianglePlane& plane) {
  Chord chord;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (sides[i] == Sign::Zero) chord.add(as_vector(triangle.points[i]), plane.foot(triangle.points[i]));
    if (sides[i] != Sign::Zero && sides[next] == -sides[i]) {
      const dvec3 crossing = crossing_point(triangle.points[i], triangle.points[next], plane);
      chord.add(crossing, crossing);
    }
  }
  return chord;
}

// How a segment lies with respect to the outline of a face.
struct Nearness {
  std::array<bool, 2> end_at_vertex{};  ///< per end: within T of a corner
  bool at_vertex = false;               ///< both ends within T of one corner
  std::vector<dvec3> directions;        ///< of the edges that both ends are within T of

  [[nodiscard]] bool along_edge() const { return !directions.empty(); }
};

bool within(const dvec3& a, const dvec3& b, double tolerance) {
  const dvec3 offset = a - b;
  return glm::dot(offset, offset) <= tolerance * tolerance;
}

bool near_corner(const std::array<dvec3, 2>& segment, const LatticeTriangle& triangle, double tolerance) {
  return std::any_of(triangle.points.begin(), triangle.points.end(), [&](const LatticePoint& corner) {
    return within(segment[0], as_vector(corner), tolerance) && within(segment[1], as_vector(corner), tolerance);
  });
}

void add_corners(const std::array<dvec3, 2>& segment, const LatticeTriangle& triangle, double tolerance,
                 Nearness& result) {
  for (const LatticePoint& corner : triangle.points) {
    const bool first = within(segment[0], as_vector(corner), tolerance);
    const bool second = within(segment[1], as_vector(corner), tolerance);
    result.end_at_vertex[0] = result.end_at_vertex[0] || first;
    result.end_at_vertex[1] = result.end_at_vertex[1] || second;
    result.at_vertex = result.at_vertex || (first && second);
  }
}

Nearness nearness(const std::array<dvec3, 2>& segment, std::span<const LatticeTriangle> face, double tolerance) {
  Nearness result;
  for (const LatticeTriangle& triangle : face) {
    add_corners(segment, triangle, tolerance, result);
    for (int i = 0; i < 3; ++i) {
      if (!triangle.boundary[i]) continue;
      const dvec3 from = as_vector(triangle.points[i]);
      const dvec3 to = as_vector(triangle.points[(i + 1) % 3]);
      const bool near = distance_to_segment(segment[0], from, to) <= tolerance &&
                        distance_to_segment(segment[1], from, to) <= tolerance;
      if (near) result.directions.push_back(to - from);
    }
  }
  return result;
}

// Two edges that run along each other within T over their shorter length: they overlap rather than cross.
bool run_together(const dvec3& a, const dvec3& b, double tolerance) {
  const double longer = std::max(glm::length(a), glm::length(b));
  return glm::length(glm::cross(a, b)) <= 2 * tolerance * longer;
}

bool edges_run_together(const Nearness& a, const Nearness& b, double tolerance) {
  return std::any_of(a.directions.begin(), a.directions.end(), [&](const dvec3& along_a) {
    return std::any_of(b.directions.begin(), b.directions.end(),
                       [&](const dvec3& along_b) { return run_together(along_a, along_b, tolerance); });
  });
}

ContactKind kind_of_point(const Nearness& a, const Nearness& b, double tolerance) {
  if (a.at_vertex && (b.at_vertex || b.along_edge())) return ContactKind::None;
  if (b.at_vertex && a.along_edge()) return ContactKind::None;
  return edges_run_together(a, b, tolerance) ? ContactKind::None : ContactKind::EdgeInFace;
}

ContactKind kind_of_segment(const Nearness& a, const Nearness& b, double tolerance) {
  // Edges that leave a corner of both at a small angle stay within T of each other for a while.
  const bool from_corner = (a.end_at_vertex[0] && b.end_at_vertex[0]) || (a.end_at_vertex[1] && b.end_at_vertex[1]);
  if (a.along_edge() && b.along_edge() && (from_corner || edges_run_together(a, b, tolerance))) {
    return ContactKind::None;
  }
  return a.along_edge() || b.along_edge() ? ContactKind::EdgeInFace : ContactKind::Crossing;
}

TriangleContact overlap_of(const LatticeTriangle& a, const LatticeTriangle& b, std::int64_t tolerance) {
  const ParallelOverlap overlap = parallel_overlap(a, b);
  TriangleContact contact;
  if (2 * overlap.region.area <= static_cast<double>(tolerance) * overlap.region.diameter) return contact;
  if (std::abs(overlap.height) > static_cast<double>(tolerance)) return contact;
  contact.kind = ContactKind::Overlap;
  contact.segment = {overlap.region.centroid, overlap.region.centroid};
  contact.size = overlap.region.area;
  contact.same_facing = overlap.same_facing;
  return contact;
}

std::optional<std::array<dvec3, 2>> clipped_chord(const LatticeTriangle& of, const Sides& sides,
                                                  const LatticeTriangle& by) {
  const Chord chord = chord_of(of, sides, by.plane);
  if (chord.count == 0) return std::nullopt;
  const int last = chord.count - 1;
  const auto share = share_in_triangle(chord.feet[0], chord.feet[last], by.points, by.plane);
  if (!share) return std::nullopt;
  const dvec3 way = chord.points[last] - chord.points[0];
  return std::array<dvec3, 2>{chord.points[0] + (*share)[0] * way, chord.points[0] + (*share)[1] * way};
}

TriangleContact contact_along(const std::optional<std::array<dvec3, 2>>& segment, const LatticeTriangle& a,
                              const LatticeTriangle& b, std::int64_t tolerance) {
  TriangleContact contact;
  if (!segment) return contact;
  const auto t = static_cast<double>(tolerance);
  contact.segment = *segment;
  contact.size = glm::distance((*segment)[0], (*segment)[1]);
  // By far the most common case in a mesh: the two meet in a corner that both have.
  if (contact.size <= t && near_corner(*segment, a, t) && near_corner(*segment, b, t)) return contact;
  contact.kind = kind_along(*segment, std::span(&a, 1), std::span(&b, 1), tolerance);
  return contact;
}

// The graver of two contacts of one pair, the longer of like ones.
const TriangleContact& graver(const TriangleContact& x, const TriangleContact& y) {
  const auto rank = [](ContactKind kind) {
    return kind == ContactKind::Crossing ? 2 : kind == ContactKind::None ? 0 : 1;
  };
  if (rank(x.kind) != rank(y.kind)) return rank(x.kind) > rank(y.kind) ? x : y;
  return x.size >= y.size ? x : y;
}

bool all_zero(const Sides& sides) {
  return std::all_of(sides.begin(), sides.end(), [](Sign sign) { return sign == Sign::Zero; });
}

bool any_zero(const Sides& sides) { return std::find(sides.begin(), sides.end(), Sign::Zero) != sides.end(); }

}  // namespace

bool near_parallel(const LatticeTriangle& a, const LatticeTriangle& b) {
  const double product = static_cast<double>(dot(a.plane.normal, b.plane.normal));
  return std::abs(product) >= kParallelCosine * a.plane.normal_length * b.plane.normal_length;
}

ParallelOverlap parallel_overlap(const LatticeTriangle& a, const LatticeTriangle& b) {
  const bool a_carries = a.plane.normal_length >= b.plane.normal_length;
  const LatticeTriangle& carrier = a_carries ? a : b;
  const LatticeTriangle& other = a_carries ? b : a;
  ParallelOverlap overlap;
  overlap.region = clipped_to_triangle(other.points, carrier.points, carrier.plane);
  if (overlap.region.area == 0) return overlap;
  const dvec3 normal = as_vector(carrier.plane.normal) / carrier.plane.normal_length;
  const dvec3 other_normal = as_vector(other.plane.normal) / other.plane.normal_length;
  const double cosine = glm::dot(normal, other_normal);
  overlap.height = glm::dot(other_normal, as_vector(other.points[0]) - overlap.region.centroid) / cosine;
  overlap.same_facing = cosine > 0;
  return overlap;
}

Sides sides_of(const LatticeTriangle& triangle, const TrianglePlane& plane, std::int64_t tolerance) {
  return {side_of_plane_within(plane, triangle.points[0], tolerance),
          side_of_plane_within(plane, triangle.points[1], tolerance),
          side_of_plane_within(plane, triangle.points[2], tolerance)};
}

bool all_on_one_side(const Sides& sides) {
  return sides[0] != Sign::Zero && sides[0] == sides[1] && sides[1] == sides[2];
}

ContactKind kind_along(const std::array<dvec3, 2>& segment, std::span<const LatticeTriangle> a,
                       std::span<const LatticeTriangle> b, std::int64_t tolerance) {
  const auto t = static_cast<double>(tolerance);
  const Nearness near_a = nearness(segment, a, t), near_b = nearness(segment, b, t);
  return glm::distance(segment[0], segment[1]) > t ? kind_of_segment(near_a, near_b, t)
                                                   : kind_of_point(near_a, near_b, t);
}

TriangleContact contact_of(const LatticeTriangle& a, const Sides& a_sides, const LatticeTriangle& b,
                           const Sides& b_sides, std::int64_t tolerance) {
  if (near_parallel(a, b)) {
    const TriangleContact overlap = overlap_of(a, b, tolerance);
    if (overlap.kind == ContactKind::Overlap) return overlap;
  }
  const bool a_in_band = all_zero(a_sides), b_in_band = all_zero(b_sides);
  // Near-parallel, a triangle in the other's band touches it over an area or not at all; else it may stand in it.
  if ((a_in_band && b_in_band) || ((a_in_band || b_in_band) && near_parallel(a, b))) return {};
  if (a_in_band) return contact_along(clipped_chord(b, b_sides, a), a, b, tolerance);
  const TriangleContact by_a = contact_along(clipped_chord(a, a_sides, b), a, b, tolerance);
  if (b_in_band || (!any_zero(a_sides) && !any_zero(b_sides))) return by_a;
  // A corner or edge that stops short of the other's plane by no more than T shows in its own chord only.
  return graver(by_a, contact_along(clipped_chord(b, b_sides, a), a, b, tolerance));
}

}  // namespace rad::geom
