// Dividing a batch of elements: nodes and blocks get their ids by counting, and are filled in parallel.
#include <tbb/parallel_for.h>

#include "mesh/element_mesh.h"

namespace rad::mesh {
namespace {

// Half of a sum, halves to the even number: rounding over and over does not drift.
std::int32_t halved(std::int64_t sum) {
  const std::int64_t floor = sum >> 1;
  return static_cast<std::int32_t>(floor + (sum & floor & 1));
}

std::int32_t quartered(std::int64_t sum) { return static_cast<std::int32_t>((sum + 2) >> 2); }

geom::LatticePoint middle_of(const geom::LatticePoint& p, const geom::LatticePoint& q) {
  return {halved(std::int64_t{p.x} + q.x), halved(std::int64_t{p.y} + q.y), halved(std::int64_t{p.z} + q.z)};
}

}  // namespace

/// Leaves of one level whose neighbours of that level all exist. In each step every element of the batch writes to its
/// own block, and reads blocks of others that earlier steps have written.
class ElementMesh::Batch {
 public:
  Batch(ElementMesh& mesh, std::span<const ElementId> elements)
      : mesh_(mesh), elements_(elements), first_block_(static_cast<BlockId>(mesh.blocks_.size())) {}

  void run() {
    mesh_.blocks_.resize(first_block_ + elements_.size());
    own_.resize(elements_.size());
    for_each([this](std::size_t i) { mesh_.children_slot(elements_[i]) = first_block_ + static_cast<BlockId>(i); });
    for_each([this](std::size_t i) { begin(i); });
    number_nodes();
    for_each([this](std::size_t i) { fill(i); });
    for_each([this](std::size_t i) { take_over(i); });
  }

 private:
  static constexpr std::uint8_t kCentreBit = 16, kBorderShift = 5;
  static constexpr std::size_t kGrain = 1024;

  template <typename Work>
  void for_each(Work&& work) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, elements_.size(), kGrain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
                      });
  }

  [[nodiscard]] Block& block(std::size_t i) const { return mesh_.blocks_[first_block_ + i]; }

  // Which new nodes are the element's own: those of edges at the border, those that the neighbour does not have and
  // does not get in this batch as the first of the two, and the centre.
  void begin(std::size_t i) {
    const ElementId element = elements_[i];
    const Corners corners = mesh_.corners(element);
    Block& block = this->block(i);
    block.parent = element;
    block.patch = mesh_.patch_of(element);
    block.level = static_cast<std::uint16_t>(mesh_.level(element) + 1);
    block.corner_count = static_cast<std::uint16_t>(corners.count);
    std::uint16_t own = corners.count == 4 ? kCentreBit : 0;
    for (std::uint32_t edge = 0; edge < corners.count; ++edge) {
      block.node[edge] = corners.node[edge];
      const Side side = mesh_.across(element, edge);
      if (side.element == kNoElement) own |= static_cast<std::uint16_t>(1U << edge | 1U << (kBorderShift + edge));
      if (side.element != kNoElement && is_first(i, side)) own |= static_cast<std::uint16_t>(1U << edge);
    }
    own_[i] = own;
  }

  // A neighbour of a coarser level is a leaf and has no middles yet.
  [[nodiscard]] bool is_first(std::size_t i, const Side& side) const {
    const BlockId there = mesh_.children(side.element);
    if (there == kNoBlock) return true;
    return there >= first_block_ + i;
  }

  // Points of the border are shared with other surfaces, so they are looked for one after the other.
  void number_nodes() {
    first_node_.resize(elements_.size());
    auto node = static_cast<NodeId>(mesh_.node_point_.size());
    auto point = static_cast<std::uint32_t>(mesh_.points_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      first_node_[i] = node;
      for (std::uint32_t bit = 0; bit < kBorderShift; ++bit) {
        if ((own_[i] >> bit & 1U) == 0) continue;
        ++node;
        mesh_.node_point_.push_back(is_border(i, bit) ? border_point(i, bit, point) : point++);
      }
    }
    mesh_.points_.resize(point);
    for (const auto& [index, place] : border_) mesh_.points_[index] = place;
  }

  // No middle is point 0, which is a corner of a patch: 0 marks a new entry.
  std::uint32_t border_point(std::size_t i, std::uint32_t edge, std::uint32_t& next) {
    const Block& block = this->block(i);
    const std::uint32_t a = mesh_.node_point_[block.node[edge]];
    const std::uint32_t b = mesh_.node_point_[block.node[(edge + 1) % block.corner_count]];
    std::uint32_t& known = mesh_.middle_points_.at(a, b);
    if (known == 0) {
      known = next++;
      border_.push_back({known, middle_of(point_at(a), point_at(b))});
    }
    return known;
  }

  // Ends of elements of the batch exist, or were made by an earlier one.
  [[nodiscard]] const geom::LatticePoint& point_at(std::uint32_t point) const { return mesh_.points_[point]; }
  [[nodiscard]] bool is_border(std::size_t i, std::uint32_t edge) const {
    return (own_[i] >> (kBorderShift + edge) & 1U) != 0;
  }

  void fill(std::size_t i) {
    Block& block = this->block(i);
    NodeId node = first_node_[i];
    for (std::uint32_t edge = 0; edge < block.corner_count; ++edge) {
      if ((own_[i] >> edge & 1U) == 0) continue;
      if (!is_border(i, edge))
        set(node, middle_of(corner(block, edge), corner(block, (edge + 1) % block.corner_count)));
      block.node[4 + edge] = node++;
    }
    if (block.corner_count != 4) return;
    std::array<std::int64_t, 3> sum{};
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
      const geom::LatticePoint& p = corner(block, slot);
      sum = {sum[0] + p.x, sum[1] + p.y, sum[2] + p.z};
    }
    block.node[kCentre] = node;
    set(node, {quartered(sum[0]), quartered(sum[1]), quartered(sum[2])});
  }

  [[nodiscard]] const geom::LatticePoint& corner(const Block& block, std::uint32_t slot) const {
    return mesh_.points_[mesh_.node_point_[block.node[slot]]];
  }

  void set(NodeId node, const geom::LatticePoint& place) const { mesh_.points_[mesh_.node_point_[node]] = place; }

  void take_over(std::size_t i) {
    Block& block = this->block(i);
    for (std::uint32_t edge = 0; edge < block.corner_count; ++edge) {
      if ((own_[i] >> edge & 1U) != 0) continue;
      const Side side = mesh_.across(elements_[i], edge);
      block.node[4 + edge] = mesh_.blocks_[mesh_.children(side.element)].node[4 + side.edge];
    }
  }

  ElementMesh& mesh_;
  std::span<const ElementId> elements_;
  BlockId first_block_;
  std::vector<std::uint16_t> own_;  ///< bits: middles of edges, the centre, and which middles lie at the border
  std::vector<NodeId> first_node_;
  std::vector<std::pair<std::uint32_t, geom::LatticePoint>> border_;  ///< new points
};

void ElementMesh::divide(std::span<const ElementId> elements) {
  for (std::size_t first = 0, last = 0; first < elements.size(); first = last) {
    while (last < elements.size() && level(elements[last]) == level(elements[first])) ++last;
    Batch(*this, elements.subspan(first, last - first)).run();
  }
}

}  // namespace rad::mesh
