#include "repair/triangle_lint.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "repair/pair_judge.h"

namespace rad::repair {
namespace {

using Found = tbb::enumerable_thread_specific<std::vector<Evidence>>;

constexpr std::size_t kGrain = 256;

template <typename Item>
void append(std::vector<Item>& to, const tbb::enumerable_thread_specific<std::vector<Item>>& parts) {
  for (const auto& part : parts) to.insert(to.end(), part.begin(), part.end());
}

void drop_outdated(std::vector<Evidence>& list, const TriangleSet& set, std::span<const std::uint8_t> is_fresh) {
  const auto outdated = [&](std::uint32_t i) { return !set.is_alive(i) || is_fresh[i] != 0; };
  std::erase_if(list, [&](const Evidence& e) { return outdated(e.violation.a) || outdated(e.other); });
}

}  // namespace

void TriangleLint::add_triangles(const TriangleSet& set, std::span<const std::uint32_t> fresh) {
  boxes_.resize(set.triangles.size());
  columns_.resize(set.triangles.size());
  in_tree_.resize(set.triangles.size(), 0);
  const auto inflation = static_cast<std::int32_t>((tolerance_ + 1) / 2);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fresh.size(), kGrain), [&](const auto& range) {
    for (std::size_t at = range.begin(); at != range.end(); ++at) {
      const std::uint32_t i = fresh[at];
      if (in_tree_[i]) continue;
      const auto& ids = set.triangles[i].points;
      const std::array corners{set.points[ids[0]], set.points[ids[1]], set.points[ids[2]]};
      boxes_[i] = geom::box_of(corners, inflation);
      columns_[i] = geom::TriangleColumn(corners);
    }
  });
}

std::vector<geom::LatticeBox> TriangleLint::boxes_of(std::span<const std::uint32_t> triangles) const {
  std::vector<geom::LatticeBox> boxes;
  boxes.reserve(triangles.size());
  for (const std::uint32_t i : triangles) boxes.push_back(boxes_[i]);
  return boxes;
}

template <typename Judge>
void TriangleLint::for_each_pair(const TriangleSet& set, std::span<const std::uint32_t> fresh, const geom::BoxTree& own,
                                 const Judge& judge) const {
  std::vector<std::uint8_t> is_fresh(tree_.empty() ? 0 : set.triangles.size(), 0);
  if (!tree_.empty()) {
    for (const std::uint32_t i : fresh) is_fresh[i] = 1;
  }
  const auto slots = static_cast<std::uint32_t>(fresh.size());
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, slots, kGrain), [&](const auto& range) {
    own.for_each_later_meeting(range.begin(), range.end(),
                               [&](std::uint32_t x, std::uint32_t y) { judge(fresh[x], fresh[y]); });
    if (tree_.empty()) return;
    own.for_each_leaf(range.begin(), range.end(),
                      [&](const geom::LatticeBox& box, std::uint32_t first, std::uint32_t last) {
                        tree_.for_each_meeting(box, [&](std::uint32_t other) {
                          if (is_fresh[other] || !set.is_alive(other)) return;
                          for (std::uint32_t slot = first; slot != last; ++slot) {
                            const std::uint32_t i = fresh[own.order()[slot]];
                            if (boxes_[i].meets(boxes_[other])) judge(i, other);
                          }
                        });
                      });
  });
}

void TriangleLint::update(const TriangleSet& set, std::span<const std::uint32_t> fresh) {
  add_triangles(set, fresh);
  std::vector<std::uint8_t> is_fresh(set.triangles.size(), 0);
  for (const std::uint32_t i : fresh) is_fresh[i] = 1;
  drop_outdated(found_, set, is_fresh);
  drop_outdated(contacts_, set, is_fresh);
  Found parts;
  tbb::enumerable_thread_specific<std::vector<TrianglePair>> near_parts;
  const PairJudge pair(*this, set);
  geom::BoxTree own(boxes_of(fresh));
  for_each_pair(set, fresh, own, [&](std::uint32_t x, std::uint32_t y) {
    if (pair.kept_apart(x, y)) return;
    pair.judge(x, y, parts.local());
    near_parts.local().push_back({x, y});
  });
  append(found_, parts);
  append(not_contacted_, near_parts);
  for (const std::uint32_t i : fresh) pair.judge_alone(i, found_);
  put_into_tree(set, fresh, std::move(own));
}

void TriangleLint::start(const TriangleSet& set, std::span<const std::uint32_t> fresh) {
  add_triangles(set, fresh);
  Found parts, contact_parts;
  tbb::enumerable_thread_specific<std::vector<TrianglePair>> opposite_parts;
  const PairJudge pair(*this, set);
  geom::BoxTree own(boxes_of(fresh));
  for_each_pair(set, fresh, own, [&](std::uint32_t x, std::uint32_t y) {
    if (pair.kept_apart(x, y)) return;
    pair.judge(x, y, parts.local());
    if (pair.judge_contact(x, y, contact_parts.local())) opposite_parts.local().push_back({x, y});
  });
  append(opposite_overlaps_, opposite_parts);
  append(found_, parts);
  append(contacts_, contact_parts);
  for (const std::uint32_t i : fresh) pair.judge_alone(i, found_);
  put_into_tree(set, fresh, std::move(own));
}

void TriangleLint::trust(const TriangleSet& set, std::span<const std::uint32_t> fresh) {
  add_triangles(set, fresh);
  put_into_tree(set, fresh, geom::BoxTree(boxes_of(fresh)));
}

void TriangleLint::put_into_tree(const TriangleSet& set, std::span<const std::uint32_t> fresh, geom::BoxTree own) {
  std::vector<std::uint32_t> added;
  for (const std::uint32_t i : fresh) {
    if (!in_tree_[i]) added.push_back(i);
    in_tree_[i] = 1;
  }
  const auto stays = [&](std::uint32_t i) {
    in_tree_[i] = set.is_alive(i) ? 1 : 0;
    return in_tree_[i] != 0;
  };
  std::vector<geom::LatticeBox> boxes = boxes_of(added);
  if (added.size() == fresh.size()) {
    tree_.add(std::move(boxes), std::move(added), std::move(own), stays);
  } else {
    tree_.add(std::move(boxes), std::move(added), stays);
  }
}

void TriangleLint::update_contacts(const TriangleSet& set) {
  Found parts;
  const PairJudge pair(*this, set);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, not_contacted_.size(), kGrain), [&](const auto& range) {
    for (std::size_t at = range.begin(); at != range.end(); ++at) {
      const auto [x, y] = not_contacted_[at];
      if (set.is_alive(x) && set.is_alive(y)) pair.judge_contact(x, y, parts.local());
    }
  });
  append(contacts_, parts);
  not_contacted_.clear();
}

namespace {

std::vector<Violation> violations_of(std::vector<Evidence> all) {
  std::sort(all.begin(), all.end());
  std::vector<Violation> list;
  for (const Evidence& evidence : all) {
    if (list.empty() || list.back() != evidence.violation) list.push_back(evidence.violation);
  }
  return list;
}

}  // namespace

// Of each triangle the first that it lies on; of each point near an edge the first triangle with that edge.
std::vector<Violation> TriangleLint::violations(const TriangleSet& set) const {
  std::vector<Violation> kept;
  std::set<std::pair<EdgeKey, PointId>> on_edges;
  for (const Violation& violation : violations_of(found_)) {
    if (violation.kind == ViolationKind::NearCoplanar && !kept.empty() && kept.back().kind == violation.kind &&
        kept.back().a == violation.a) {
      continue;
    }
    if (violation.kind == ViolationKind::PointOnEdge) {
      const auto& ids = set.triangles[violation.a].points;
      const EdgeKey edge = edge_key(ids[violation.b], ids[(violation.b + 1) % 3]);
      if (!on_edges.insert({edge, violation.point}).second) continue;
    }
    kept.push_back(violation);
  }
  return kept;
}

std::vector<Violation> TriangleLint::contacts() const { return violations_of(contacts_); }

bool has_no_fault(const TriangleSet& set, std::int64_t tolerance) {
  std::vector<std::uint32_t> all(set.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  std::erase_if(all, [&](std::uint32_t i) { return !set.is_alive(i); });
  TriangleLint lint(tolerance);
  lint.start(set, all);
  bool any = false;
  lint.for_each_evidence([&](const Evidence&) { any = true; });
  return !any;
}

}  // namespace rad::repair
