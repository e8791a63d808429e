#include "solve/sight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "solve/random.h"

namespace rad::solve {
namespace {

/// A lone visible stratum among at least this many blocked ones may be a ray that slipped between two triangles.
constexpr std::uint32_t kSuspectBlocked = 8;

dvec3 point_in_triangle(const dvec3& a, const dvec3& b, const dvec3& c, double u, double v) {
  const double root = std::sqrt(u);
  return a + (b - a) * (root * (1 - v)) + (c - a) * (root * v);
}

/// Uniform over a polygon of any number of corners, as a fan of triangles.
dvec3 point_in_fan(const ConvexPolygon& polygon, std::array<double, 2> random) {
  std::array<double, 8> until{};
  const dvec3& apex = polygon.corner[0];
  for (std::uint32_t i = 2; i < polygon.count; ++i) {
    const dvec3 twice = glm::cross(polygon.corner[i - 1] - apex, polygon.corner[i] - apex);
    until[i] = until[i - 1] + glm::length(twice);
  }
  const double wanted = random[0] * until[polygon.count - 1];
  std::uint32_t i = 2;
  while (i + 1 < polygon.count && until[i] < wanted) ++i;
  const double within = until[i] > until[i - 1] ? (wanted - until[i - 1]) / (until[i] - until[i - 1]) : 0.5;
  return point_in_triangle(apex, polygon.corner[i - 1], polygon.corner[i], std::clamp(within, 0.0, 1.0), random[1]);
}

/// Uniform over the polygon, but for a quadrilateral that is no parallelogram: uniform in its parameters there.
dvec3 point_in(const ConvexPolygon& polygon, std::array<double, 2> random) {
  const auto& corner = polygon.corner;
  const auto [u, v] = random;
  if (polygon.count == 3) return point_in_triangle(corner[0], corner[1], corner[2], u, v);
  if (polygon.count == 4) {
    return (corner[0] * (1 - u) + corner[1] * u) * (1 - v) + (corner[3] * (1 - u) + corner[2] * u) * v;
  }
  return point_in_fan(polygon, random);
}

/// Rays of one step, and whose votes they are.
struct Rays {
  std::vector<Segment> segment;
  std::vector<std::uint8_t> blocked;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> owner;  ///< sight, stratum
};

struct Look {
  const StratifiedRadiator& radiator;
  std::span<const Receiver> receivers;
  const Visibility& visibility;

  [[nodiscard]] Segment ray(const Sight& sight, const ConvexPolygon& polygon, std::uint32_t stratum,
                            std::uint32_t attempt) const {
    const Receiver& receiver = receivers[sight.receiver];
    const auto round = static_cast<std::uint32_t>(2 * sight.step + attempt);
    const dvec3 target = point_in(polygon, jitter(radiator.key, sight.receiver, stratum, round));
    return {receiver.position, receiver.position + target + radiator.lift};
  }

  void aim(Sights& sights, std::uint32_t index, Rays& rays) const {
    Sight& sight = sights.sight[index];
    const std::vector<Stratum>& strata = radiator.step[sight.step];
    sight.first_vote = sights.vote.size();
    sights.vote.resize(sights.vote.size() + strata.size(), Vote::BelowHorizon);
    sight.visible = sight.blocked = 0;
    for (std::uint32_t i = 0; i < strata.size(); ++i) {
      const ConvexPolygon polygon = above_horizon(strata[i].all(), receivers[sight.receiver]);
      if (polygon.count == 0) continue;
      rays.segment.push_back(ray(sight, polygon, i, 0));
      rays.owner.emplace_back(index, i);
    }
  }

  void count(Sights& sights, Rays& rays) const {
    rays.blocked.resize(rays.segment.size());
    visibility.trace(rays.segment, rays.blocked);
    for (std::size_t i = 0; i < rays.owner.size(); ++i) {
      Sight& sight = sights.sight[rays.owner[i].first];
      sights.vote[sight.first_vote + rays.owner[i].second] = rays.blocked[i] ? Vote::Blocked : Vote::Visible;
      ++(rays.blocked[i] ? sight.blocked : sight.visible);
    }
  }

  void confirm_lone(Sights& sights, Sight& sight) const {
    if (sight.visible != 1 || sight.blocked < kSuspectBlocked) return;
    const auto first = sights.vote.begin() + static_cast<std::ptrdiff_t>(sight.first_vote);
    const auto lone = std::find(first, sights.vote.end(), Vote::Visible);
    const auto stratum = static_cast<std::uint32_t>(lone - first);
    const ConvexPolygon polygon = above_horizon(radiator.step[sight.step][stratum].all(), receivers[sight.receiver]);
    const Segment again = ray(sight, polygon, stratum, 1);
    std::uint8_t blocked = 0;
    visibility.trace({&again, 1}, {&blocked, 1});
    if (!blocked) return;
    *lone = Vote::Blocked;
    sight.visible = 0;
    ++sight.blocked;
  }
};

std::uint32_t level_for(std::size_t cells, std::size_t wanted) {
  std::uint32_t level = 0;
  for (std::size_t count = cells; count < wanted; count *= 4) ++level;
  return level;
}

}  // namespace

StratifiedRadiator stratified(std::uint32_t key, const dvec3& lift, std::vector<Stratum> cells, std::size_t fewest,
                              std::size_t most) {
  StratifiedRadiator radiator{key, lift, std::move(cells), {}, {}};
  radiator.level.push_back(level_for(radiator.cell.size(), fewest));
  const std::uint32_t last = level_for(radiator.cell.size(), most);
  if (last > radiator.level.back()) radiator.level.push_back(last);
  for (const std::uint32_t level : radiator.level) {
    std::vector<Stratum>& step = radiator.step.emplace_back();
    for (const Stratum& cell : radiator.cell) {
      for (const Stratum& stratum : strata(cell, level)) step.push_back(stratum);
    }
  }
  return radiator;
}

Sights look(const StratifiedRadiator& radiator, std::span<const ReceiverId> receiver_ids,
            std::span<const Receiver> receivers, const Visibility& visibility) {
  const Look looking{radiator, receivers, visibility};
  Sights sights;
  sights.sight.resize(receiver_ids.size());
  for (std::size_t i = 0; i < receiver_ids.size(); ++i) sights.sight[i].receiver = receiver_ids[i];
  Rays rays;
  rays.segment.reserve(sights.sight.size() * radiator.step[0].size());
  rays.owner.reserve(rays.segment.capacity());
  for (std::size_t step = 0; step < radiator.step.size(); ++step) {
    rays.segment.clear();
    rays.owner.clear();
    for (std::uint32_t i = 0; i < sights.sight.size(); ++i) {
      Sight& sight = sights.sight[i];
      if (step > 0 && (sight.visible == 0 || sight.blocked == 0)) continue;
      sight.step = step;
      looking.aim(sights, i, rays);
    }
    if (rays.segment.empty()) break;
    looking.count(sights, rays);
  }
  for (Sight& sight : sights.sight) looking.confirm_lone(sights, sight);
  return sights;
}

}  // namespace rad::solve
