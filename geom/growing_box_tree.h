// A tree of integer boxes that grows by batches: a search asks every batch, and a batch joins the one before it as soon
// as that is not much larger, so there are never more than a few.
#pragma once

#include <span>
#include <vector>

#include "geom/box_tree.h"

namespace rad::geom {

class GrowingBoxTree {
 public:
  /// Adds `boxes` as items `items[i]`. Items that `is_alive` refuses are left out when batches join; until then
  /// searches still find them.
  template <typename IsAlive>
  void add(std::vector<LatticeBox> boxes, std::vector<std::uint32_t> items, IsAlive&& is_alive) {
    BoxTree tree(boxes);
    add(std::move(boxes), std::move(items), std::move(tree), is_alive);
  }
  /// The same where the tree of the boxes is there already.
  template <typename IsAlive>
  void add(std::vector<LatticeBox> boxes, std::vector<std::uint32_t> items, BoxTree tree, IsAlive&& is_alive) {
    if (items.empty()) return;
    bool joined = false;
    while (!batches_.empty() && batches_.back().items.size() < kLeastRatio * items.size()) {
      const Batch& last = batches_.back();
      for (std::size_t slot = 0; slot < last.items.size(); ++slot) {
        if (!is_alive(last.items[slot])) continue;
        boxes.push_back(last.boxes[slot]);
        items.push_back(last.items[slot]);
      }
      batches_.pop_back();
      joined = true;
    }
    if (joined) tree = BoxTree(boxes);
    batches_.push_back({std::move(boxes), std::move(items), std::move(tree)});
  }

  [[nodiscard]] bool empty() const { return batches_.empty(); }

  /// Calls visit(item) for every item whose box meets `query`.
  template <typename Visit>
  void for_each_meeting(const LatticeBox& query, Visit&& visit) const {
    for (const Batch& batch : batches_) {
      batch.tree.for_each_meeting(query, [&](std::uint32_t slot) { visit(batch.items[slot]); });
    }
  }

  /// Calls visit(item) for every item whose box the segment comes within `reach` of (SegmentReach).
  template <typename Visit>
  void for_each_near_segment(const dvec3& from, const dvec3& to, double reach, Visit&& visit) const {
    for (const Batch& batch : batches_) {
      batch.tree.for_each_near_segment(from, to, reach, [&](std::uint32_t slot) { visit(batch.items[slot]); });
    }
  }

 private:
  static constexpr std::size_t kLeastRatio = 3;

  struct Batch {
    std::vector<LatticeBox> boxes;
    std::vector<std::uint32_t> items;
    BoxTree tree;
  };

  std::vector<Batch> batches_;  ///< each at least kLeastRatio times as large as the next
};

}  // namespace rad::geom
