#include "geom/planar_clip.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::geom {
namespace {

// Pitches: far above what rounding does to a point, far below any tolerance.
constexpr double kEdgeSlack = 0x1p-10;

struct Planar {
  double u = 0;
  double v = 0;
};

Planar flattened(const dvec3& point, int dropped) {
  if (dropped == 0) return {point.y, point.z};
  if (dropped == 1) return {point.z, point.x};
  return {point.x, point.y};
}

double component(const IntVector& v, int axis) { return static_cast<double>(axis == 0 ? v.x : axis == 1 ? v.y : v.z); }

// Twice the signed area of edge and point; positive inside a counter-clockwise triangle.
double side(const Planar& from, const Planar& to, const Planar& point) {
  return (to.u - from.u) * (point.v - from.v) - (to.v - from.v) * (point.u - from.u);
}

/// The clip triangle seen along its dominant axis, turned counter-clockwise.
struct ClipTriangle {
  int dropped;
  std::array<Planar, 3> corners;

  ClipTriangle(const std::array<LatticePoint, 3>& points, const TrianglePlane& plane)
      : dropped(dominant_axis(plane.normal)) {
    for (int i = 0; i < 3; ++i) corners[i] = flattened(as_vector(points[i]), dropped);
    if (component(plane.normal, dropped) < 0) std::swap(corners[1], corners[2]);
  }
};

using Ring = std::array<Planar, 8>;

// Sutherland–Hodgman: a triangle cut by three half planes keeps at most six corners.
int cut(const Ring& input, int count, const Planar& from, const Planar& to, Ring& output) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const Planar& here = input[i];
    const Planar& next = input[(i + 1) % count];
    const double at_here = side(from, to, here), at_next = side(from, to, next);
    if (at_here >= 0) output[kept++] = here;
    if ((at_here > 0 && at_next < 0) || (at_here < 0 && at_next > 0)) {
      const double t = at_here / (at_here - at_next);
      output[kept++] = {here.u + t * (next.u - here.u), here.v + t * (next.v - here.v)};
    }
  }
  return kept;
}

// Back onto the plane along the dropped axis.
dvec3 lifted(const Planar& point, const TrianglePlane& plane, int dropped) {
  const dvec3 through = as_vector(plane.through);
  const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  dvec3 result;
  result[u] = point.u;
  result[v] = point.v;
  const double slope =
      component(plane.normal, u) * (point.u - through[u]) + component(plane.normal, v) * (point.v - through[v]);
  result[dropped] = through[dropped] - slope / component(plane.normal, dropped);
  return result;
}

}  // namespace

PlanarRegion clipped_to_triangle(const std::array<LatticePoint, 3>& subject, const std::array<LatticePoint, 3>& clip,
                                 const TrianglePlane& plane) {
  const ClipTriangle triangle(clip, plane);
  Ring ring, other;
  for (int i = 0; i < 3; ++i) ring[i] = flattened(plane.foot(subject[i]), triangle.dropped);
  int count = 3;
  for (int i = 0; i < 3 && count > 0; ++i) {
    count = cut(ring, count, triangle.corners[i], triangle.corners[(i + 1) % 3], other);
    std::swap(ring, other);
  }
  PlanarRegion region;
  if (count < 3) return region;
  double doubled = 0;
  Planar middle;
  for (int i = 0; i < count; ++i) {
    doubled += side(ring[0], ring[i], ring[(i + 1) % count]);
    middle.u += ring[i].u / count;
    middle.v += ring[i].v / count;
  }
  const double stretch = plane.normal_length / std::abs(component(plane.normal, triangle.dropped));
  region.area = 0.5 * std::abs(doubled) * stretch;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      region.diameter = std::max(region.diameter, glm::distance(lifted(ring[i], plane, triangle.dropped),
                                                                lifted(ring[j], plane, triangle.dropped)));
    }
  }
  region.centroid = lifted(middle, plane, triangle.dropped);
  return region;
}

std::optional<std::array<double, 2>> share_in_triangle(const dvec3& from, const dvec3& to,
                                                       const std::array<LatticePoint, 3>& clip,
                                                       const TrianglePlane& plane) {
  const ClipTriangle triangle(clip, plane);
  const Planar start = flattened(from, triangle.dropped), end = flattened(to, triangle.dropped);
  double enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    const Planar& a = triangle.corners[i];
    const Planar& b = triangle.corners[(i + 1) % 3];
    const double slack = kEdgeSlack * (std::abs(b.u - a.u) + std::abs(b.v - a.v));
    const double at_start = side(a, b, start), at_end = side(a, b, end);
    if (at_start < -slack && at_end < -slack) return std::nullopt;
    if (at_start < -slack) enter = std::max(enter, std::min(1.0, at_start / (at_start - at_end)));
    if (at_end < -slack) leave = std::min(leave, std::max(0.0, at_start / (at_start - at_end)));
  }
  if (enter <= leave) return std::array{enter, leave};
  // Through a corner, or past it?
  if ((enter - leave) * std::hypot(end.u - start.u, end.v - start.v) > kEdgeSlack) return std::nullopt;
  return std::array{leave, leave};
}

}  // namespace rad::geom
