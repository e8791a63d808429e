// A tree of integer boxes for finding all pairs that touch.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace rad::geom {

/// Closed box on the lattice. Inflated boxes may leave the lattice range; int32 holds them.
struct LatticeBox {
  std::array<std::int32_t, 3> low{};
  std::array<std::int32_t, 3> high{};

  [[nodiscard]] bool meets(const LatticeBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1] &&
           low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

/// Asks boxes whether a segment comes near them.
class SegmentReach {
 public:
  /// `reach` in pitches.
  SegmentReach(const dvec3& from, const dvec3& to, double reach);

  /// Whether the segment comes within reach of the box along every axis at once: true for every segment that comes
  /// within reach of it, and for some that pass a corner a little farther off.
  [[nodiscard]] bool nears(const LatticeBox& box) const {
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
      // Where the segment does not move along the axis the shares are infinite: in or out for good.
      const double low = (box.low[axis] - high_start_[axis]) * inverse_[axis];
      const double high = (box.high[axis] - low_start_[axis]) * inverse_[axis];
      first = std::max(first, std::min(low, high));
      last = std::min(last, std::max(low, high));
    }
    return first <= last + kSlack;
  }

 private:
  // Shares of the way, widened for rounding: far below what a pitch is of the longest segment.
  static constexpr double kSlack = 1e-12;

  std::array<double, 3> low_start_;   ///< start of the way less the reach
  std::array<double, 3> high_start_;  ///< and more
  std::array<double, 3> inverse_;     ///< of the way
};

LatticeBox box_of(std::span<const LatticePoint> points, std::int32_t inflation = 0);
LatticeBox united(const LatticeBox& a, const LatticeBox& b);

/// Binary tree over boxes, halved at the median of the longest axis of the centres. Which pairs are found does not
/// depend on the tree's shape, so not on the order of the boxes either.
class BoxTree {
 public:
  explicit BoxTree(std::vector<LatticeBox> boxes);

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  /// Boxes in the order of the leaves: neighbours in this order are near in space.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

  /// Calls visit(item) for every box that meets `query`.
  template <typename Visit>
  void for_each_meeting(const LatticeBox& query, Visit&& visit) const {
    for_each_where([&](const LatticeBox& box) { return box.meets(query); }, visit);
  }

  /// Calls visit(item) for every box that the segment comes within `reach` of (SegmentReach).
  template <typename Visit>
  void for_each_near_segment(const dvec3& from, const dvec3& to, double reach, Visit&& visit) const {
    const SegmentReach query(from, to, reach);
    for_each_where([&](const LatticeBox& box) { return query.nears(box); }, visit);
  }

  /// Calls visit(item, other) once for every pair of boxes that meet, where the item is at one of the slots of order()
  /// from `first` to before `last` and the other at a later slot than the item.
  template <typename Visit>
  void for_each_later_meeting(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for_each_leaf_node(first, last, [&](const Node& leaf) {
      meetings_of_leaf(leaf, std::max(leaf.begin, first), std::min(leaf.last, last), visit);
    });
  }

  /// Calls visit(box, first, last) for the slots of order() from `first` to before `last`, a few at a time that lie
  /// near each other, with a box around them.
  template <typename Visit>
  void for_each_leaf(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for_each_leaf_node(first, last, [&](const Node& leaf) {
      visit(leaf.box, std::max(leaf.begin, first), std::min(leaf.last, last));
    });
  }

 private:
  /// A leaf holds `count` boxes from slot `first`; an inner node has count 0 and children first, first + 1.
  /// `begin` is the first slot below the node, `last` one past the last.
  struct Node {
    LatticeBox box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t begin = 0;
    std::uint32_t last = 0;
  };
  using Stack = std::array<std::uint32_t, 64>;
  struct Centre;

  template <typename Visit>
  void for_each_leaf_node(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    Stack stack;
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.last <= first || node.begin >= last) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      visit(node);
    }
  }

  // The later meetings of a leaf's slots from `first` to before `last`: one walk for all of them.
  template <typename Visit>
  void meetings_of_leaf(const Node& leaf, std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    Stack stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.last <= first + 1 || !node.box.meets(leaf.box)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      for (std::uint32_t slot = first; slot < last; ++slot) {
        for (std::uint32_t other = std::max(node.begin, slot + 1); other < node.last; ++other) {
          if (boxes_[other].meets(boxes_[slot])) visit(order_[slot], order_[other]);
        }
      }
    }
  }

  // `accepts` holds for a box whenever it holds for a box within it.
  template <typename Accepts, typename Visit>
  void for_each_where(Accepts&& accepts, Visit&& visit) const {
    if (nodes_.empty()) return;
    Stack stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!accepts(node.box)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
        if (accepts(boxes_[slot])) visit(order_[slot]);
      }
    }
  }

  void build(std::uint32_t node, std::uint32_t begin, std::span<Centre> centres, std::span<const LatticeBox> input);

  std::vector<LatticeBox> boxes_;     ///< in leaf order
  std::vector<std::uint32_t> order_;  ///< item of each slot
  std::vector<Node> nodes_;
};

}  // namespace rad::geom
