#include "repair/edge_uses.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace rad::repair {
namespace {

// The greater end of an edge in the high half, the side in the low one.
using EndAndSide = std::uint64_t;

template <typename Visit>
void for_each_side(const PlanarTriangles& set, Visit&& visit) {
  Side side = 0;
  for (const PlanarTriangles::Member& member : set.members) {
    for (std::size_t k = 0; k < 3; ++k) visit(member.points[k], member.points[(k + 1) % 3], side++);
  }
}

}  // namespace

EdgeUses::EdgeUses(const PlanarTriangles& set) {
  std::vector<std::uint32_t> first(set.points.size() + 1, 0);
  for_each_side(set, [&](PointId a, PointId b, Side) { ++first[std::min(a, b) + 1]; });
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<EndAndSide> listed(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for_each_side(set, [&](PointId a, PointId b, Side side) {
    listed[next[std::min(a, b)]++] = EndAndSide{std::max(a, b)} << 32 | side;
  });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, set.points.size(), 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      std::sort(listed.begin() + first[i], listed.begin() + first[i + 1]);
    }
  });
  sides_.reserve(listed.size());
  first_edge_.reserve(first.size());
  for (std::size_t point = 0; point < set.points.size(); ++point) {
    first_edge_.push_back(edge_count());
    for (std::uint32_t i = first[point]; i < first[point + 1]; ++i) {
      const auto end = static_cast<PointId>(listed[i] >> 32);
      if (i == first[point] || greater_end_.back() != end) {
        greater_end_.push_back(end);
        first_side_.push_back(i);
      }
      sides_.push_back(static_cast<Side>(listed[i]));
    }
  }
  first_edge_.push_back(edge_count());
  first_side_.push_back(static_cast<std::uint32_t>(sides_.size()));
}

std::span<const Side> EdgeUses::between(PointId a, PointId b) const {
  const auto [lesser, greater] = std::minmax(a, b);
  const auto begin = greater_end_.begin() + first_edge_[lesser], end = greater_end_.begin() + first_edge_[lesser + 1];
  const auto found = std::lower_bound(begin, end, greater);
  if (found == end || *found != greater) return {};
  return on_edge(static_cast<std::uint32_t>(found - greater_end_.begin()));
}

}  // namespace rad::repair
