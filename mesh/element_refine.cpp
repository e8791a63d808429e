// Refining batches of elements: balance, and leaves with a middle on every edge.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "mesh/element_mesh.h"
#include "mesh/lengths.h"

namespace rad::mesh {
namespace {

// A piece of an anchored triangle has a quarter of its area at least, and no longer edge: a quarter of its width.
constexpr double kAnchoredWidths = 4;

double width_of(std::span<const geom::dvec3> corners) {
  double width = std::numeric_limits<double>::infinity();
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const geom::dvec3 &from = corners[i], &to = corners[(i + 1) % count];
    width = std::min(width, glm::distance(from, to));
    for (std::size_t k = i + 2; k < i + count; ++k) {
      width = std::min(width, geom::distance_to_segment(corners[k % count], from, to));
    }
  }
  return width;
}

}  // namespace

/// Which leaves a batch divides. An element may be divided where it is large enough and all its coarser neighbours,
/// which balance divides with it, may be: levels fall along such a chain, so it ends.
class ElementMesh::Closure {
 public:
  explicit Closure(const ElementMesh& mesh) : mesh_(mesh), answers_(mesh.element_count(), Answer::Unknown) {}

  void add(ElementId element) {
    if (mesh_.is_leaf(element) && may_divide(element)) take(element);
  }

  /// Coarse levels first, then by id.
  [[nodiscard]] std::vector<ElementId> in_order() {
    std::sort(taken_.begin(), taken_.end(),
              [&](ElementId a, ElementId b) { return std::pair(mesh_.level(a), a) < std::pair(mesh_.level(b), b); });
    return taken_;
  }

 private:
  enum class Answer : std::uint8_t { Unknown, No, Yes, Taken };

  bool may_divide(ElementId element) {
    if (answers_[element] != Answer::Unknown) return answers_[element] != Answer::No;
    bool may = mesh_.large_enough(element) && mesh_.neighbours_large_enough(element);
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
  std::vector<Answer> answers_;
  std::vector<ElementId> taken_;
};

// The least distance of a corner from another corner or from an edge that it does not belong to.
double ElementMesh::width(ElementId element) const {
  const Corners own = corners(element);
  std::array<geom::dvec3, 4> place;
  for (std::uint32_t i = 0; i < own.count; ++i) place[i] = geom::as_vector(points_[node_point_[own.node[i]]]);
  return width_of(std::span(place).first(own.count));
}

// Of the element of the same level on the other side of an edge: there already, or a child to be of a coarser one.
double ElementMesh::width_across(ElementId element, std::uint32_t edge) const {
  const Corners own = corners(element);
  const NodeId from = own.node[edge], to = own.node[(edge + 1) % own.count];
  const ElementId other = other_side(from, to);
  if (other != kNoElement) return width(other);
  const ElementId coarser = coarser_neighbour(element, edge);
  return coarser == kNoElement ? std::numeric_limits<double>::infinity() : width(coarser) / 2;
}

// The middles of an edge are points of every surface at it: a narrow patch whose edge another surface divides on and on
// would be shown as a fan of triangles thinner than T. So no patch is divided deeper than the narrowest at its edges.
void ElementMesh::limit_levels() {
  const auto levels_of = [&](ElementId patch) {
    std::uint32_t levels = 0;
    if (sources_[patch].whole) return levels;
    for (double left = width(patch); left >= 2 * least_spacing(tolerance_); left /= 2) ++levels;
    return levels;
  };
  const auto edge_of = [&](const Corners& corners, std::uint32_t edge) {
    const std::uint32_t a = node_point_[corners.node[edge]];
    const std::uint32_t b = node_point_[corners.node[(edge + 1) % corners.count]];
    return std::array{std::min(a, b), std::max(a, b)};
  };
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> of_edge;
  for (ElementId patch = 0; patch < roots_.size(); ++patch) {
    deepest_.push_back(levels_of(patch));
    for (std::uint32_t edge = 0; edge < roots_[patch].corners.count; ++edge) {
      std::uint32_t& least = of_edge.try_emplace(edge_of(roots_[patch].corners, edge), deepest_[patch]).first->second;
      least = std::min(least, deepest_[patch]);
    }
  }
  for (ElementId patch = 0; patch < roots_.size(); ++patch) {
    for (std::uint32_t edge = 0; edge < roots_[patch].corners.count; ++edge) {
      deepest_[patch] = std::min(deepest_[patch], of_edge.at(edge_of(roots_[patch].corners, edge)));
    }
  }
}

bool ElementMesh::large_enough(ElementId element) const {
  return level(element) < deepest_[patch_of(element)] && width(element) >= 2 * least_spacing(tolerance_);
}

bool ElementMesh::neighbours_large_enough(ElementId element) const {
  const std::uint32_t count = corners(element).count;
  for (std::uint32_t edge = 0; edge < count; ++edge) {
    if (width_across(element, edge) < kAnchoredWidths * least_spacing(tolerance_)) return false;
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
