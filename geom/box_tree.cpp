#include "geom/box_tree.h"

#include <tbb/parallel_invoke.h>

#include <cmath>
#include <numeric>

namespace rad::geom {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::uint32_t kParallelSize = 4096;

// Twice the centre: an integer, so that halving never rounds.
std::int64_t doubled_centre(const LatticeBox& box, int axis) { return std::int64_t{box.low[axis]} + box.high[axis]; }

int longest_axis(std::span<const std::uint32_t> items, std::span<const LatticeBox> boxes) {
  std::array<std::int64_t, 3> low, high;
  low.fill(INT64_MAX);
  high.fill(INT64_MIN);
  for (const std::uint32_t item : items) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t centre = doubled_centre(boxes[item], axis);
      low[axis] = std::min(low[axis], centre);
      high[axis] = std::max(high[axis], centre);
    }
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  return longest;
}

// Nodes of a subtree over `count` boxes: leaves hold 1 to kLeafSize, halves are floor and ceiling.
std::uint32_t subtree_nodes(std::uint32_t count) {
  if (count <= kLeafSize) return 1;
  const std::uint32_t left = subtree_nodes(count / 2);
  const std::uint32_t right = count % 2 == 0 ? left : subtree_nodes(count - count / 2);
  return 1 + left + right;
}

}  // namespace

SegmentReach::SegmentReach(const dvec3& from, const dvec3& to, double reach) {
  // A way shorter than this, pitches, is none: its shares would overflow.
  constexpr double kNoWay = 1e-30;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to[axis] - from[axis];
    low_start_[axis] = from[axis] - reach;
    high_start_[axis] = from[axis] + reach;
    inverse_[axis] = 1 / (std::abs(way) < kNoWay ? kNoWay : way);
  }
}

LatticeBox box_of(std::span<const LatticePoint> points, std::int32_t inflation) {
  LatticeBox box;
  box.low.fill(INT32_MAX);
  box.high.fill(INT32_MIN);
  for (const LatticePoint& point : points) {
    const std::array<std::int32_t, 3> c{point.x, point.y, point.z};
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], c[axis]);
      box.high[axis] = std::max(box.high[axis], c[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] -= inflation;
    box.high[axis] += inflation;
  }
  return box;
}

LatticeBox united(const LatticeBox& a, const LatticeBox& b) {
  LatticeBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(a.low[axis], b.low[axis]);
    box.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return box;
}

BoxTree::BoxTree(std::vector<LatticeBox> boxes) {
  const auto count = static_cast<std::uint32_t>(boxes.size());
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  if (count == 0) return;
  nodes_.resize(subtree_nodes(count));
  nodes_[0].first = 1;
  build(0, 0, count, boxes);
  boxes_.resize(count);
  for (std::uint32_t slot = 0; slot < count; ++slot) boxes_[slot] = boxes[order_[slot]];
}

// Children lie side by side at node.first, which the parent has set to the first free place of its subtree; the left
// child's descendants follow both children, then the right child's.
void BoxTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, std::span<const LatticeBox> input) {
  const std::uint32_t count = end - begin;
  Node& self = nodes_[node];
  self.last = end;
  if (count <= kLeafSize) {
    self.first = begin;
    self.count = count;
    self.box = input[order_[begin]];
    for (std::uint32_t slot = begin + 1; slot < end; ++slot) self.box = united(self.box, input[order_[slot]]);
    return;
  }
  const auto items = std::span(order_).subspan(begin, count);
  const int axis = longest_axis(items, input);
  const auto middle = items.begin() + count / 2;
  std::nth_element(items.begin(), middle, items.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::int64_t ca = doubled_centre(input[a], axis), cb = doubled_centre(input[b], axis);
    return ca != cb ? ca < cb : a < b;
  });
  const std::uint32_t left = self.first, right = left + 1, split = begin + count / 2;
  nodes_[left].first = left + 2;
  nodes_[right].first = left + 2 + (subtree_nodes(count / 2) - 1);
  const auto build_left = [&] { build(left, begin, split, input); };
  const auto build_right = [&] { build(right, split, end, input); };
  if (count > kParallelSize) {
    tbb::parallel_invoke(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
  self.box = united(nodes_[left].box, nodes_[right].box);
}

}  // namespace rad::geom
