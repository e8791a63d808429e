#include "repair/weld.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tsl/robin_map.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "geom/tolerance.h"

namespace rad::repair {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
// So wide, a search meets four cells or so.
constexpr double kGridCellInReaches = 3;

class Welder {
 public:
  Welder(std::span<const LatticePoint> points, double tolerance, std::span<const std::uint8_t> mask)
      : points_(points),
        tolerance_(tolerance),
        reach_(geom::kWeldRatio * tolerance),
        grid_(kGridCellInReaches * reach_),
        target_(points.size()),
        multiplicity_(points.size(), 0) {
    std::iota(target_.begin(), target_.end(), 0u);
    merge_equal(mask);
  }

  std::vector<std::uint32_t> run() {
    leave_lonely();
    if (live_.empty()) return std::move(target_);
    members_.resize(points_.size());
    for (const std::uint32_t id : live_) members_[id] = {id};
    while (contract_mutually_nearest()) {
    }
    keep_independent();
    return resolved();
  }

 private:
  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(geom::as_vector(points_[a]), geom::as_vector(points_[b]));
  }

  // live_ becomes the first of every group of equal points, in the order of space.
  void merge_equal(std::span<const std::uint8_t> mask) {
    const auto precedes = [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; };
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (mask.empty() || mask[i]) live_.push_back(i);
    }
    for (const std::uint32_t i : live_) multiplicity_[i] = 1;
    // As points of a lattice model are: then no two are equal.
    const auto not_before = [&](std::uint32_t a, std::uint32_t b) { return !precedes(a, b); };
    if (std::ranges::adjacent_find(live_, not_before) == live_.end()) return;
    tsl::robin_map<LatticePoint, std::uint32_t, PointHash> first_at;
    std::erase_if(live_, [&](std::uint32_t i) {
      const auto [first, is_new] = first_at.try_emplace(points_[i], i);
      target_[i] = first->second;
      if (!is_new) ++multiplicity_[target_[i]];
      return !is_new;
    });
    tbb::parallel_sort(live_.begin(), live_.end(), precedes);
  }

  struct PointHash {
    std::size_t operator()(const LatticePoint& point) const {
      const auto part = [](std::int32_t value) { return static_cast<std::uint64_t>(value) & 0x1ffffff; };
      const std::uint64_t mixed = (part(point.x) << 39 ^ part(point.y) << 20 ^ part(point.z)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(mixed ^ (mixed >> 29));
    }
  };

  // By far the most points have no other within reach: nothing happens to them.
  void leave_lonely() {
    fill_grid(live_);
    std::vector<std::uint8_t> lonely(live_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, live_.size(), 512), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) lonely[i] = nearest(live_[i]) == kNone ? 1 : 0;
    });
    std::size_t at = 0;
    std::erase_if(live_, [&](std::uint32_t) { return lonely[at++] != 0; });
  }

  void fill_grid(std::span<const std::uint32_t> ids) {
    grid_.clear();
    for (const std::uint32_t id : ids) grid_.add(id, points_[id]);
  }

  // The nearest other point of the grid within reach; ties go to the first in space.
  [[nodiscard]] std::uint32_t nearest(std::uint32_t to) const {
    std::uint32_t best = kNone;
    double best_distance = 0;
    grid_.for_each_near(geom::as_vector(points_[to]), reach_, [&](std::uint32_t id) {
      if (id == to) return;
      const double away = distance(to, id);
      if (away > reach_) return;
      if (best == kNone || away < best_distance || (away == best_distance && points_[id] < points_[best])) {
        best = id;
        best_distance = away;
      }
    });
    return best;
  }

  [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const {
    if (multiplicity_[a] != multiplicity_[b]) return multiplicity_[a] > multiplicity_[b];
    return points_[a] < points_[b];
  }

  bool contract(std::uint32_t winner, std::uint32_t loser) {
    const auto far = [&](std::uint32_t member) { return distance(member, winner) > tolerance_ / 2; };
    if (std::ranges::any_of(members_[loser], far)) return false;
    multiplicity_[winner] += multiplicity_[loser];
    members_[winner].insert(members_[winner].end(), members_[loser].begin(), members_[loser].end());
    members_[loser].clear();
    return true;
  }

  bool contract_mutually_nearest() {
    fill_grid(live_);
    std::vector<std::uint32_t> nearest_of(points_.size(), kNone);
    for (const std::uint32_t id : live_) nearest_of[id] = nearest(id);
    bool changed = false;
    for (const std::uint32_t id : live_) {
      const std::uint32_t other = nearest_of[id];
      if (other == kNone || nearest_of[other] != id || points_[other] < points_[id]) continue;
      changed |= before(id, other) ? contract(id, other) : contract(other, id);
    }
    std::erase_if(live_, [&](std::uint32_t id) { return members_[id].empty(); });
    return changed;
  }

  void keep_independent() {
    std::vector<std::uint32_t> order = live_;
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return before(a, b); });
    grid_.clear();
    std::vector<std::uint32_t> taken_in;
    for (const std::uint32_t id : order) {
      if (nearest(id) == kNone) {
        grid_.add(id, points_[id]);
      } else {
        taken_in.push_back(id);
      }
    }
    hop_.assign(points_.size(), kNone);
    for (const std::uint32_t id : taken_in) hop_[id] = nearest(id);
  }

  [[nodiscard]] std::vector<std::uint32_t> resolved() const {
    std::vector<std::uint32_t> contracted(points_.size());
    std::iota(contracted.begin(), contracted.end(), 0u);
    for (const std::uint32_t id : live_) {
      for (const std::uint32_t member : members_[id]) contracted[member] = id;
    }
    std::vector<std::uint32_t> result(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const std::uint32_t kept = contracted[target_[i]];
      result[i] = hop_[kept] == kNone ? kept : hop_[kept];
    }
    return result;
  }

  std::span<const LatticePoint> points_;
  double tolerance_;
  double reach_;
  PointGrid grid_;
  std::vector<std::uint32_t> target_;                ///< per point: the first of its equals
  std::vector<std::size_t> multiplicity_;            ///< per representative: how many points it stands for
  std::vector<std::vector<std::uint32_t>> members_;  ///< per representative
  std::vector<std::uint32_t> live_;                  ///< representatives, in the order of space
  std::vector<std::uint32_t> hop_;                   ///< per representative that is taken in: by whom
};

}  // namespace

std::vector<std::uint32_t> weld(std::span<const LatticePoint> points, double tolerance,
                                std::span<const std::uint8_t> mask) {
  return Welder(points, tolerance, mask).run();
}

}  // namespace rad::repair
