#include "scene/triangle_shares.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rad::scene {

using geom::dvec3;

namespace {

// Shares of the ends of a segment at its point nearest to `point`; `from` where it has no length.
std::array<double, 2> shares_on_segment(const dvec3& from, const dvec3& to, const dvec3& point) {
  const dvec3 along = to - from;
  const double squared = glm::dot(along, along);
  const double share = squared > 0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
  return {1 - share, share};
}

// Shares of the corners at the foot of `point` in the plane of a triangle; nothing sound (NaN) where it has no area.
std::array<double, 3> shares_in_plane(const std::array<dvec3, 3>& place, const dvec3& point) {
  const dvec3 normal = glm::cross(place[1] - place[0], place[2] - place[0]);
  const double squared = glm::dot(normal, normal);
  const double first = glm::dot(glm::cross(place[2] - place[1], point - place[1]), normal) / squared;
  const double second = glm::dot(glm::cross(place[0] - place[2], point - place[2]), normal) / squared;
  return {first, second, 1 - first - second};
}

}  // namespace

std::array<double, 3> nearest_shares(const std::array<dvec3, 3>& place, const dvec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (point != place[i]) continue;
    std::array<double, 3> whole{};
    whole[i] = 1;
    return whole;
  }
  const std::array<double, 3> inside = shares_in_plane(place, point);
  if (std::ranges::all_of(inside, [](double share) { return share >= 0; })) return inside;
  std::array<double, 3> best{1, 0, 0};
  double least = glm::distance(place[0], point);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto ends = shares_on_segment(place[i], place[j], point);
    std::array<double, 3> share{};
    share[i] = ends[0];
    share[j] = ends[1];
    const double distance = glm::distance(blend(place, share), point);
    if (!(distance < least)) continue;
    least = distance;
    best = share;
  }
  return best;
}

}  // namespace rad::scene
