// Refining batches of elements: balance, and leaves with a middle on every edge.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/edge_levels.h"
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

// The sides of what a quadrilateral is divided into run between its own sides, so the area that they span lies between
// those at its corners: no element of level n is narrower than 2^-n of the least of these over the longest side.
// Rounding to the lattice takes less than 2 pitches.
float certain_width_of(std::span<const geom::dvec3> corners) {
  double least = std::numeric_limits<double>::infinity(), longest = 0;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const geom::dvec3 to = corners[(i + 1) % count] - corners[i], back = corners[(i + count - 1) % count] - corners[i];
    least = std::min(least, glm::length(glm::cross(to, back)));
    longest = std::max(longest, glm::length(to));
  }
  return static_cast<float>(least / longest * (1 - 1e-6));
}

}  // namespace

/// Which leaves a batch divides. An element may be divided where it is large enough and all its coarser neighbours,
/// which balance divides with it, may be: levels fall along such a chain, so it ends.
class ElementMesh::Closure {
 public:
  explicit Closure(ElementMesh& mesh) : mesh_(mesh) { mesh.answers_.resize(mesh.element_count(), kUnknown); }
  ~Closure() {
    for (const ElementId element : asked_) mesh_.answers_[element] = kUnknown;
  }
  Closure(const Closure&) = delete;
  Closure& operator=(const Closure&) = delete;

  /// Asks first, all at once, what each would need by itself: the costly part.
  void add(std::span<const ElementId> elements) {
    std::vector<std::uint8_t> fit(elements.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, elements.size(), kGrain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i) {
                          fit[i] = mesh_.is_leaf(elements[i]) && fits(elements[i]) ? 1 : 0;
                        }
                      });
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (fit[i] != 0 && may_divide(elements[i], true)) take(elements[i]);
    }
  }

  /// Coarse levels first, then by id.
  [[nodiscard]] std::vector<ElementId> in_order() {
    std::sort(taken_.begin(), taken_.end(),
              [&](ElementId a, ElementId b) { return std::pair(mesh_.level(a), a) < std::pair(mesh_.level(b), b); });
    return taken_;
  }

 private:
  enum Answer : std::uint8_t { kUnknown, kNo, kYes, kTaken };
  static constexpr std::size_t kGrain = 1024;

  [[nodiscard]] bool fits(ElementId element) const {
    return mesh_.large_enough(element) && mesh_.neighbours_large_enough(element);
  }

  bool may_divide(ElementId element, bool fit) {
    if (mesh_.answers_[element] != kUnknown) return mesh_.answers_[element] != kNo;
    bool may = fit;
    const std::uint32_t count = mesh_.corner_count(element);
    for (std::uint32_t edge = 0; may && edge < count; ++edge) {
      const ElementId coarser = mesh_.coarser_neighbour(element, edge);
      may = coarser == kNoElement || may_divide(coarser, fits(coarser));
    }
    mesh_.answers_[element] = may ? kYes : kNo;
    asked_.push_back(element);
    return may;
  }

  void take(ElementId element) {
    if (mesh_.answers_[element] == kTaken) return;
    mesh_.answers_[element] = kTaken;
    taken_.push_back(element);
    const std::uint32_t count = mesh_.corner_count(element);
    for (std::uint32_t edge = 0; edge < count; ++edge) {
      const ElementId coarser = mesh_.coarser_neighbour(element, edge);
      if (coarser != kNoElement) take(coarser);
    }
  }

  ElementMesh& mesh_;
  std::vector<ElementId> asked_;
  std::vector<ElementId> taken_;
};

// The least distance of a corner from another corner or from an edge that it does not belong to.
double ElementMesh::width(ElementId element) const {
  const std::array<geom::dvec3, 4> place = corner_places(element);
  return width_of(std::span(place).first(corner_count(element)));
}

std::array<geom::dvec3, 4> ElementMesh::corner_places(ElementId element) const {
  const Corners own = corners(element);
  std::array<geom::dvec3, 4> place;
  for (std::uint32_t i = 0; i < own.count; ++i) place[i] = geom::as_vector(points_[node_point_[own.node[i]]]);
  return place;
}

// Of the element of the same level on the other side of an edge: there already, or a child to be of a coarser one.
double ElementMesh::width_across(ElementId element, std::uint32_t edge) const {
  const Side side = across(element, edge);
  if (side.element == kNoElement) return std::numeric_limits<double>::infinity();
  const bool coarser = level(side.element) < level(element);
  if (const double certain = certain_width(side.element); certain >= 2 * kAnchoredWidths * least_spacing(tolerance_)) {
    return coarser ? certain / 2 : certain;
  }
  return coarser ? width(side.element) / 2 : width(side.element);
}

double ElementMesh::certain_width(ElementId element) const {
  return std::ldexp(double{certain_width_[patch_of(element)]}, -static_cast<int>(level(element))) - 2;
}

// The middles of an edge are points of every surface at it: a narrow patch whose edge another surface divides on and on
// would be shown as a fan of triangles thinner than T, also where what has the edge is a piece of an anchored element;
// and a middle may lie within T of an edge that leaves the same corner. So no patch is divided deeper than its edges
// allow.
void ElementMesh::limit_levels() {
  const double spacing = least_spacing(tolerance_);
  const auto levels_of = [&](ElementId patch, double least) {
    std::uint32_t levels = 0;
    if (sources_[patch].whole) return levels;
    for (double left = width(patch); left >= 2 * least; left /= 2) ++levels;
    return levels;
  };
  const auto for_each_edge = [&](ElementId patch, const auto& visit) {
    const Root& root = roots_[patch];
    for (std::uint32_t edge = 0; edge < root.corners.count; ++edge) {
      const NodeId next = root.corners.node[(edge + 1) % root.corners.count];
      visit(node_point_[root.corners.node[edge]], node_point_[next], root.across[edge].element == kNoElement);
    }
  };
  EdgeLevels edges;
  for (ElementId patch = 0; patch < roots_.size(); ++patch) {
    deepest_.push_back(levels_of(patch, spacing));
    const std::uint32_t at_border = levels_of(patch, kAnchoredWidths * spacing);
    const std::array<geom::dvec3, 4> place = corner_places(patch);
    certain_width_.push_back(certain_width_of(std::span(place).first(roots_[patch].corners.count)));
    for_each_edge(patch, [&](std::uint32_t a, std::uint32_t b, bool border) {
      edges.allow(a, b, border ? at_border : deepest_[patch]);
    });
  }
  edges.keep_apart(points_, spacing);
  for (ElementId patch = 0; patch < roots_.size(); ++patch) {
    for_each_edge(patch, [&](std::uint32_t a, std::uint32_t b, bool) {
      deepest_[patch] = std::min(deepest_[patch], edges.of(a, b));
    });
  }
}

bool ElementMesh::large_enough(ElementId element) const {
  if (level(element) >= deepest_[patch_of(element)]) return false;
  const double least = 2 * least_spacing(tolerance_);
  return certain_width(element) >= least || width(element) >= least;
}

bool ElementMesh::neighbours_large_enough(ElementId element) const {
  const std::uint32_t count = corner_count(element);
  for (std::uint32_t edge = 0; edge < count; ++edge) {
    if (width_across(element, edge) < kAnchoredWidths * least_spacing(tolerance_)) return false;
  }
  return true;
}

// Leaves that a batch left with a middle on every edge. Dividing them adds none to any other edge.
std::vector<ElementId> ElementMesh::enclosed_by(std::span<const ElementId> divided) const {
  std::vector<ElementId> enclosed;
  for (const ElementId element : divided) {
    const std::uint32_t count = corner_count(element);
    for (std::uint32_t edge = 0; edge < count; ++edge) {
      const ElementId other = across(element, edge).element;
      if (other == kNoElement || !is_leaf(other)) continue;
      const std::uint32_t edges = corner_count(other);
      std::uint32_t middles = 0;
      while (middles < edges && middle(other, middles) != kNoNode) ++middles;
      if (middles == edges && large_enough(other)) enclosed.push_back(other);
    }
  }
  std::sort(enclosed.begin(), enclosed.end(),
            [&](ElementId a, ElementId b) { return std::pair(level(a), a) < std::pair(level(b), b); });
  enclosed.erase(std::unique(enclosed.begin(), enclosed.end()), enclosed.end());
  return enclosed;
}

NodeRange ElementMesh::refine(std::span<const ElementId> elements) {
  NodeRange added{static_cast<NodeId>(node_count()), 0};
  std::vector<ElementId> divided;
  {
    Closure closure(*this);
    closure.add(elements);
    divided = closure.in_order();
  }
  divide(divided);
  divide(enclosed_by(divided));
  added.last = static_cast<NodeId>(node_count());
  return added;
}

}  // namespace rad::mesh
