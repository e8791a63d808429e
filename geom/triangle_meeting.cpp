#include "geom/triangle_meeting.h"

#include <algorithm>

namespace rad::geom {
namespace {

using Triangle = std::array<LatticePoint, 3>;
using PlanarTriangle3 = std::array<PlanarPoint, 3>;

int as_int(Sign sign) { return static_cast<int>(sign); }

bool on_closed_segment(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  return orient2d(a, b, p) == Sign::Zero && std::min(a.u, b.u) <= p.u && p.u <= std::max(a.u, b.u) &&
         std::min(a.v, b.v) <= p.v && p.v <= std::max(a.v, b.v);
}

bool segments_meet(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) {
  const int abc = as_int(orient2d(a, b, c)), abd = as_int(orient2d(a, b, d));
  const int cda = as_int(orient2d(c, d, a)), cdb = as_int(orient2d(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return on_closed_segment(c, a, b) || on_closed_segment(d, a, b) || on_closed_segment(a, c, d) ||
         on_closed_segment(b, c, d);
}

bool in_closed_triangle(const PlanarPoint& p, const PlanarTriangle3& t) {
  const int s0 = as_int(orient2d(t[0], t[1], p)), s1 = as_int(orient2d(t[1], t[2], p)),
            s2 = as_int(orient2d(t[2], t[0], p));
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

bool coplanar_segment_meets(const LatticePoint& from, const LatticePoint& to, const Triangle& t,
                            const IntVector& normal) {
  const int axis = dominant_axis(normal);
  const PlanarPoint p = project(from, axis), q = project(to, axis);
  const PlanarTriangle3 flat{project(t[0], axis), project(t[1], axis), project(t[2], axis)};
  if (in_closed_triangle(p, flat) || in_closed_triangle(q, flat)) return true;
  for (int i = 0; i < 3; ++i) {
    if (segments_meet(p, q, flat[i], flat[(i + 1) % 3])) return true;
  }
  return false;
}

bool meets(const LatticePoint& from, const LatticePoint& to, const Triangle& t, const TrianglePlane& plane) {
  const int at_from = as_int(sign_of(plane.value(from))), at_to = as_int(sign_of(plane.value(to)));
  if (at_from * at_to > 0) return false;
  if (at_from == 0 && at_to == 0) return coplanar_segment_meets(from, to, t, plane.normal);
  const int s0 = as_int(orient3d(from, to, t[0], t[1])), s1 = as_int(orient3d(from, to, t[1], t[2])),
            s2 = as_int(orient3d(from, to, t[2], t[0]));
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

TrianglePlane plane_of(const Triangle& t) { return {t[0], t[1], t[2]}; }

bool wholly_aside(const Triangle& t, const TrianglePlane& plane) {
  const int a = as_int(sign_of(plane.value(t[0])));
  return a != 0 && a == as_int(sign_of(plane.value(t[1]))) && a == as_int(sign_of(plane.value(t[2])));
}

bool any_edge_meets(const Triangle& edges_of, const Triangle& t, const TrianglePlane& plane) {
  for (int i = 0; i < 3; ++i) {
    if (meets(edges_of[i], edges_of[(i + 1) % 3], t, plane)) return true;
  }
  return false;
}

// Corners rotated so that shared ones come first; `count` of them.
struct Shared {
  int count = 0;
  std::array<int, 3> own_a{0, 1, 2};
  std::array<int, 3> own_b{0, 1, 2};
};

Shared shared_corners(const Triangle& a, const Triangle& b) {
  std::array<bool, 3> in_a{}, in_b{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] == b[j]) in_a[i] = in_b[j] = true;
    }
  }
  Shared shared;
  shared.count = static_cast<int>(std::count(in_a.begin(), in_a.end(), true));
  std::stable_sort(shared.own_a.begin(), shared.own_a.end(), [&](int i, int j) { return in_a[i] && !in_a[j]; });
  std::stable_sort(shared.own_b.begin(), shared.own_b.end(), [&](int i, int j) { return in_b[i] && !in_b[j]; });
  return shared;
}

// Both share an edge: they meet beyond it only where they lie on one side of it in one plane.
bool folded_over(const Triangle& a, const Triangle& b, const Shared& shared, const TrianglePlane& plane) {
  const LatticePoint& apex = a[shared.own_a[2]];
  const LatticePoint& other = b[shared.own_b[2]];
  if (plane.value(other) != 0) return false;
  const int axis = dominant_axis(plane.normal);
  const PlanarPoint p = project(a[shared.own_a[0]], axis), q = project(a[shared.own_a[1]], axis);
  return as_int(orient2d(p, q, project(apex, axis))) * as_int(orient2d(p, q, project(other, axis))) > 0;
}

}  // namespace

bool segment_meets_triangle(const LatticePoint& from, const LatticePoint& to, const Triangle& triangle) {
  return meets(from, to, triangle, plane_of(triangle));
}

bool meet_beyond_shared_corners(const Triangle& a, const Triangle& b) {
  const Shared shared = shared_corners(a, b);
  if (shared.count == 3) return true;
  const TrianglePlane a_plane = plane_of(a);
  if (shared.count == 2) return folded_over(a, b, shared, a_plane);
  if (wholly_aside(b, a_plane)) return false;
  const TrianglePlane b_plane = plane_of(b);
  if (wholly_aside(a, b_plane)) return false;
  if (shared.count == 0) return any_edge_meets(a, b, b_plane) || any_edge_meets(b, a, a_plane);
  return meets(a[shared.own_a[1]], a[shared.own_a[2]], b, b_plane) ||
         meets(b[shared.own_b[1]], b[shared.own_b[2]], a, a_plane);
}

}  // namespace rad::geom
