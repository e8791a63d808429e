// The last resort: the closest points of a violation become one. Each merge leaves fewer points, so this ends.

#include <algorithm>
#include <limits>

#include "geom/triangle_contact.h"
#include "repair/distance.h"
#include "repair/residual_round.h"

namespace rad::repair {
namespace {

struct Closest {
  PointId first = 0;
  PointId second = 0;
  double distance = std::numeric_limits<double>::infinity();
};

void consider(const Complex& complex, PointId u, PointId v, Closest& closest) {
  const double away = complex.distance(u, v);
  if (u == v || away > closest.distance) return;
  const bool first = std::minmax(u, v) < std::minmax(closest.first, closest.second);
  if (away < closest.distance || first) closest = {u, v, away};
}

}  // namespace

dvec3 Residual::Round::middle_of_contact(const Triangle& a, const Triangle& b) const {
  const auto on_lattice = [&](const Triangle& t) {
    return geom::LatticeTriangle({complex.point(t.points[0]), complex.point(t.points[1]), complex.point(t.points[2])},
                                 {true, true, true});
  };
  const auto v = corners(a);
  const geom::LatticeTriangle p = on_lattice(a), q = on_lattice(b);
  if (geom::near_parallel(p, q)) {
    const geom::ParallelOverlap overlap = geom::parallel_overlap(p, q);
    if (overlap.region.area > 0) return nearest_on_triangle(overlap.region.centroid, v);
  }
  return (v[0] + v[1] + v[2]) / 3.0;
}

bool Residual::Round::merge_closest(std::span<const Violation> violations) {
  std::set<PointId> touched;
  for (const Violation& violation : violations) {
    const Triangle& a = triangle(violation.a);
    std::set<PointId> involved(a.points.begin(), a.points.end());
    const bool on_edge = violation.kind == ViolationKind::PointOnEdge;
    if (on_edge) {
      involved.insert(violation.point);
    } else {
      involved.insert(triangle(violation.b).points.begin(), triangle(violation.b).points.end());
    }
    Closest closest;
    for (const PointId u : involved) {
      for (const PointId v : involved) {
        if (u < v) consider(complex, u, v, closest);
      }
    }
    if (on_edge) {
      const Cluster& own = complex.clusters()[a.cluster];
      const PointId point = violation.point;
      const bool carries_edge = std::ranges::any_of(complex.neighbours(point), [&](PointId other) {
        return complex.edge_in_cluster(edge_key(point, other), a.cluster);
      });
      if (residual.steiner_.contains(point) && own.points.contains(point) && !carries_edge) {
        complex.drop_point(a.cluster, point);
        changed = true;
        continue;
      }
      const auto consider_other = [&](PointId other) {
        if (other != point && !residual.steiner_.contains(other)) consider(complex, point, other, closest);
      };
      for (const PointId other : own.points) consider_other(other);
      for (const EdgeKey edge : own.edges) {
        for (const PointId other : ends_of(edge)) consider_other(other);
      }
      involved.insert({closest.first, closest.second});
    }
    if (std::ranges::any_of(involved, [&](PointId id) { return touched.contains(id); })) continue;
    if (closest.distance <= kFarthestMerge * complex.weld_distance() &&
        complex.merge_either(closest.first, closest.second)) {
      touched.insert(involved.begin(), involved.end());
      ++residual.counts_.local_merges;
      changed = true;
    } else if (violation.kind == ViolationKind::NearCoplanar) {
      // Too far apart to merge: a common point in the middle of the gap.
      const Triangle& b = triangle(violation.b);
      const dvec3 middle = middle_of_contact(a, b);
      const dvec3 between = 0.5 * (middle + nearest_on_triangle(middle, corners(b)));
      PointId contact = complex.point_at(between, reach);
      const auto in_both = [&](PointId id) {
        return complex.in_cluster(id, a.cluster) && complex.in_cluster(id, b.cluster);
      };
      if (in_both(contact)) contact = complex.point_at(between, complex.tolerance());
      imprint_point(a.cluster, contact);
      imprint_point(b.cluster, contact);
    }
  }
  return changed;
}

}  // namespace rad::repair
