#include "repair/plane_snap.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "geom/box_tree.h"
#include "repair/distance.h"

namespace rad::repair {
namespace {

// Below these the planes are too nearly parallel for their intersection to be near: sin² of the angle of two, and the
// volume of three unit normals.
constexpr double kLeastSquaredSine = 1e-8;
constexpr double kLeastVolume = 1e-5;

std::optional<dvec3> nearest_in_all(std::span<const Plane* const> planes, const dvec3& from) {
  const auto height = [&](std::size_t i) { return planes[i]->height(from); };
  const dvec3& a = planes[0]->normal;
  if (planes.size() == 1) return from - height(0) * a;
  const dvec3& b = planes[1]->normal;
  if (planes.size() == 2) {
    const double cosine = glm::dot(a, b), determinant = 1 - cosine * cosine;
    if (determinant < kLeastSquaredSine) return std::nullopt;
    const double x = (height(0) - cosine * height(1)) / determinant;
    const double y = (height(1) - cosine * height(0)) / determinant;
    return from - x * a - y * b;
  }
  const dvec3& c = planes[2]->normal;
  const double volume = glm::dot(a, glm::cross(b, c));
  if (std::abs(volume) < kLeastVolume) return std::nullopt;
  return from - (height(0) * glm::cross(b, c) + height(1) * glm::cross(c, a) + height(2) * glm::cross(a, b)) / volume;
}

void add_once(std::vector<ClusterId>& list, ClusterId id) {
  if (std::find(list.begin(), list.end(), id) == list.end()) list.push_back(id);
}

std::vector<std::vector<ClusterId>> planes_of_points(const Soup& soup, const PlaneClaims& claims, double tolerance,
                                                     std::span<const std::uint8_t> movable) {
  std::vector<std::vector<ClusterId>> planes(soup.points.size());
  std::vector<geom::LatticeBox> boxes;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < soup.pieces.size(); ++i) {
    const SoupPiece& piece = soup.pieces[i];
    for (const auto& edge : soup.edges_of(piece)) add_once(planes[edge[0]], claims.leader_of_piece[i]);
    if (piece.edge_count != 3) continue;
    triangles.push_back(i);
    boxes.push_back(geom::box_of(soup.triangle(piece)));
  }
  const geom::BoxTree tree(std::move(boxes));
  const auto inflation = static_cast<std::int32_t>(std::ceil(tolerance));
  for (PointId id = 0; id < soup.points.size(); ++id) {
    if (planes[id].empty() || (!movable.empty() && !movable[id])) continue;
    std::vector<ClusterId> near;
    tree.for_each_meeting(geom::box_of(std::span(&soup.points[id], 1), inflation), [&](std::uint32_t at) {
      const auto corners = soup.triangle(soup.pieces[triangles[at]]);
      if (distance_to_triangle(geom::as_vector(soup.points[id]), corners) > tolerance) return;
      add_once(near, claims.leader_of_piece[triangles[at]]);
    });
    for (const ClusterId cluster : near) add_once(planes[id], cluster);
    std::sort(planes[id].begin(), planes[id].end());
  }
  return planes;
}

LatticePoint snapped(const LatticePoint& point, std::span<const ClusterId> clusters, const PlaneClaims& claims,
                     double budget) {
  const dvec3 from = geom::as_vector(point);
  dvec3 best = from;
  std::vector<const Plane*> used;
  for (const ClusterId cluster : clusters) {
    if (used.size() == 3) break;
    used.push_back(&claims.leaders[cluster].plane);
    const auto place = nearest_in_all(used, from);
    if (place && glm::distance(*place, from) <= budget) {
      best = *place;
    } else {
      used.pop_back();
    }
  }
  return {static_cast<std::int32_t>(std::lround(best.x)), static_cast<std::int32_t>(std::lround(best.y)),
          static_cast<std::int32_t>(std::lround(best.z))};
}

}  // namespace

SnapCounts snap_to_planes(Soup& soup, const PlaneClaims& claims, double tolerance,
                          std::span<const std::uint8_t> movable) {
  const auto planes = planes_of_points(soup, claims, tolerance, movable);
  SnapCounts counts;
  for (PointId id = 0; id < soup.points.size(); ++id) {
    if (!movable.empty() && !movable[id]) continue;
    const LatticePoint point = soup.points[id];
    const bool off = std::ranges::any_of(planes[id], [&](ClusterId cluster) {
      return std::abs(claims.leaders[cluster].plane.height(point)) > kSnapBandShare * tolerance;
    });
    if (!off) continue;
    const LatticePoint moved = snapped(point, planes[id], claims, kSnapBudget * tolerance);
    if (moved == point) continue;
    soup.points[id] = moved;
    ++counts.moved;
    counts.largest = std::max(counts.largest, glm::distance(geom::as_vector(point), geom::as_vector(moved)));
  }
  return counts;
}

}  // namespace rad::repair
