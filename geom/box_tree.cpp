#include "geom/box_tree.h"

#include <tbb/parallel_invoke.h>

#include <cmath>

namespace rad::geom {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::uint32_t kParallelSize = 4096;

template <typename Centre>
std::size_t longest_axis(std::span<const Centre> centres) {
  std::array<std::int32_t, 3> low = centres.front().place, high = low;
  for (const Centre& centre : centres) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], centre.place[axis]);
      high[axis] = std::max(high[axis], centre.place[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
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

// What sorting looks at, side by side in memory. Places are twice the centre: integers, so that halving never rounds.
struct BoxTree::Centre {
  std::array<std::int32_t, 3> place{};
  std::uint32_t item = 0;
};

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
  if (count == 0) return;
  std::vector<Centre> centres(count);
  for (std::uint32_t item = 0; item < count; ++item) {
    const LatticeBox& box = boxes[item];
    centres[item] = {{box.low[0] + box.high[0], box.low[1] + box.high[1], box.low[2] + box.high[2]}, item};
  }
  nodes_.resize(subtree_nodes(count));
  nodes_[0].first = 1;
  build(0, 0, centres, boxes);
  order_.reserve(count);
  boxes_.reserve(count);
  for (const Centre& centre : centres) {
    order_.push_back(centre.item);
    boxes_.push_back(boxes[centre.item]);
  }
}

// Children lie side by side at node.first, which the parent has set to the first free place of its subtree; the left
// child's descendants follow both children, then the right child's.
void BoxTree::build(std::uint32_t node, std::uint32_t begin, std::span<Centre> centres,
                    std::span<const LatticeBox> input) {
  const auto count = static_cast<std::uint32_t>(centres.size());
  Node& self = nodes_[node];
  self.begin = begin;
  self.last = begin + count;
  if (count <= kLeafSize) {
    self.first = begin;
    self.count = count;
    self.box = input[centres.front().item];
    for (const Centre& centre : centres.subspan(1)) self.box = united(self.box, input[centre.item]);
    return;
  }
  const std::size_t axis = longest_axis<Centre>(centres);
  const std::uint32_t half = count / 2;
  std::nth_element(centres.begin(), centres.begin() + half, centres.end(), [axis](const Centre& a, const Centre& b) {
    return a.place[axis] != b.place[axis] ? a.place[axis] < b.place[axis] : a.item < b.item;
  });
  const std::uint32_t left = self.first, right = left + 1;
  nodes_[left].first = left + 2;
  nodes_[right].first = left + 2 + (subtree_nodes(half) - 1);
  const auto build_left = [&] { build(left, begin, centres.first(half), input); };
  const auto build_right = [&] { build(right, begin + half, centres.subspan(half), input); };
  if (count > kParallelSize) {
    tbb::parallel_invoke(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
  self.box = united(nodes_[left].box, nodes_[right].box);
}

}  // namespace rad::geom
