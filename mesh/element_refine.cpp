// Refining batches of elements: balance, and leaves with a middle on every edge.
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "mesh/element_mesh.h"
#include "mesh/lengths.h"

namespace rad::mesh {

/// Which leaves a batch divides. An element may be divided where it is large enough and all its coarser neighbours,
/// which balance divides with it, may be: levels fall along such a chain, so it ends.
class ElementMesh::Closure {
 public:
  explicit Closure(const ElementMesh& mesh) : mesh_(mesh) {}

  void add(ElementId element) {
    if (mesh_.is_leaf(element) && may_divide(element)) take(element);
  }

  /// Coarse levels first, then by id.
  [[nodiscard]] std::vector<ElementId> in_order() {
    std::sort(taken_.begin(), taken_.end(), [&](ElementId a, ElementId b) {
      return std::pair(mesh_.level(a), a) < std::pair(mesh_.level(b), b);
    });
    return taken_;
  }

 private:
  enum class Answer : std::uint8_t { No, Yes, Taken };

  bool may_divide(ElementId element) {
    const auto known = answers_.find(element);
    if (known != answers_.end()) return known->second != Answer::No;
    bool may = mesh_.large_enough(element);
    const std::uint32_t count = mesh_.corners(element).count;
    for (std::uint32_t edge = 0; may && edge < count; ++edge) {
      const ElementId coarser = mesh_.coarser_neighbour(element, edge);
      may = coarser == kNoElement || may_divide(coarser);
    }
    answers_[element] = may ? Answer::Yes : Answer::No;
    return may;
  }

  void take(ElementId element) {
    Answer& answer = answers_[element];
    if (answer == Answer::Taken) return;
    answer = Answer::Taken;
    taken_.push_back(element);
    const std::uint32_t count = mesh_.corners(element).count;
    for (std::uint32_t edge = 0; edge < count; ++edge) {
      const ElementId coarser = mesh_.coarser_neighbour(element, edge);
      if (coarser != kNoElement) take(coarser);
    }
  }

  const ElementMesh& mesh_;
  std::unordered_map<ElementId, Answer> answers_;
  std::vector<ElementId> taken_;
};

bool ElementMesh::large_enough(ElementId element) const {
  const double least = 2 * least_spacing(tolerance_);
  const Corners own = corners(element);
  const auto place = [&](std::uint32_t corner) {
    return geom::as_vector(points_[node_point_[own.node[corner % own.count]]]);
  };
  for (std::uint32_t i = 0; i < own.count; ++i) {
    if (glm::distance(place(i), place(i + 1)) < least) return false;
    for (std::uint32_t k = i + 2; k < i + own.count; ++k) {
      if (geom::distance_to_segment(place(k), place(i), place(i + 1)) < least) return false;
    }
  }
  return true;
}

NodeRange ElementMesh::refine(std::span<const ElementId> elements) {
  NodeRange added{static_cast<NodeId>(node_count()), 0};
  Closure closure(*this);
  for (const ElementId element : elements) closure.add(element);
  const std::vector<ElementId> divided = closure.in_order();
  for (const ElementId element : divided) divide(element);

  // Leaves that these left with a middle on every edge: dividing them adds none to any other edge.
  std::vector<ElementId> enclosed;
  for (const ElementId element : divided) {
    const Corners own = corners(element);
    for (std::uint32_t i = 0; i < own.count; ++i) {
      const ElementId other = other_side(own.node[i], own.node[(i + 1) % own.count]);
      if (other == kNoElement || !is_leaf(other) || !large_enough(other)) continue;
      const Corners corners_there = corners(other);
      const std::array<NodeId, 4> middle = middles(corners_there);
      const auto end = middle.begin() + corners_there.count;
      if (std::find(middle.begin(), end, kNoNode) == end) enclosed.push_back(other);
    }
  }
  std::sort(enclosed.begin(), enclosed.end());
  enclosed.erase(std::unique(enclosed.begin(), enclosed.end()), enclosed.end());
  for (const ElementId element : enclosed) divide(element);
  added.last = static_cast<NodeId>(node_count());
  return added;
}

}  // namespace rad::mesh
