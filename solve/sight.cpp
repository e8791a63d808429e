#include "solve/sight.h"

#include <algorithm>

#include "solve/jitter_points.h"
#include "solve/random.h"

namespace rad::solve {
namespace {

/// A lone visible stratum among at least this many blocked ones may be a ray that slipped between two triangles.
constexpr std::uint32_t kSuspectBlocked = 8;

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
