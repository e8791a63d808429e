#include "repair/outline_loops.h"

#include <algorithm>

namespace rad::repair {

void OutlineLoops::start(std::span<const std::array<PointId, 2>> edges) {
  edges_ = edges;
  from_.clear();
  next_.clear();
  end_.clear();
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (from_.empty() || from_.back() != edges[i][0]) {
      from_.push_back(edges[i][0]);
      next_.push_back(i);
      end_.push_back(i);
    }
    ++end_.back();
  }
}

std::uint32_t OutlineLoops::group_of(PointId from) const {
  const auto found = std::lower_bound(from_.begin(), from_.end(), from);
  if (found == from_.end() || *found != from) return kNowhere;
  return static_cast<std::uint32_t>(found - from_.begin());
}

void OutlineLoops::close_loop(PointId at, std::vector<std::vector<PointId>>& loops) {
  const auto seen = chain_.begin() + place_[at];
  std::vector<PointId>& loop = loops.emplace_back(seen, chain_.end());
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  for (auto id = seen + 1; id != chain_.end(); ++id) place_[*id] = kNowhere;
  chain_.erase(seen + 1, chain_.end());
}

void OutlineLoops::take_chain(std::uint32_t first, std::vector<std::vector<PointId>>& loops) {
  chain_.assign(1, from_[first]);
  place_[chain_.front()] = 0;
  for (std::uint32_t group = first; group != kNowhere && next_[group] != end_[group]; group = group_of(chain_.back())) {
    const PointId to = edges_[next_[group]++][1];
    if (place_[to] != kNowhere) {
      close_loop(to, loops);
    } else {
      place_[to] = static_cast<std::uint32_t>(chain_.size());
      chain_.push_back(to);
    }
  }
  for (const PointId id : chain_) place_[id] = kNowhere;
}

std::vector<std::vector<PointId>> OutlineLoops::of(std::span<const std::array<PointId, 2>> edges) {
  start(edges);
  std::vector<std::vector<PointId>> loops;
  for (std::uint32_t group = 0; group < from_.size(); ++group) {
    while (next_[group] != end_[group]) take_chain(group, loops);
  }
  return loops;
}

}  // namespace rad::repair
