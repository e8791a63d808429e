// The element library as the paper's pseudo code has it, with neighbours found by looking at every pair of leaves.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/element_mesh.h"
#include "tests/support/conforming_builder.h"

namespace rad::tests {

using Outline = std::vector<geom::dvec3>;

/// The same polygon but for rounding, wherever it starts.
inline bool alike(const Outline& a, const Outline& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t turn = 0; turn < a.size(); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < a.size(); ++i) same = same && glm::distance(a[i], b[(i + turn) % a.size()]) < 4;
    if (same) return true;
  }
  return false;
}

class NaiveElements {
 public:
  struct Leaf {
    Outline corners;
    int level = 0;
    int surface = 0;
  };

  void add(Outline corners, int surface) { leaves_.push_back({std::move(corners), 0, surface}); }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }

  /// Leaves that balance has already divided are not found again.
  void refine(const std::vector<Outline>& chosen) {
    for (const Outline& outline : chosen) {
      for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (!alike(leaves_[i].corners, outline)) continue;
        subdivide(i);
        break;
      }
    }
    for (bool found = true; found;) {
      found = false;
      for (std::size_t i = 0; i < leaves_.size() && !found; ++i) {
        if (!enclosed(leaves_[i])) continue;
        subdivide(i);
        found = true;
      }
    }
  }

 private:
  static geom::dvec3 half(const geom::dvec3& a, const geom::dvec3& b) { return (a + b) * 0.5; }

  void subdivide(std::size_t index) {
    const Leaf leaf = leaves_[index];
    leaves_.erase(leaves_.begin() + static_cast<std::ptrdiff_t>(index));
    const auto& c = leaf.corners;
    const auto add_child = [&](Outline child) { leaves_.push_back({std::move(child), leaf.level + 1, leaf.surface}); };
    const std::size_t n = c.size();
    geom::dvec3 centre(0, 0, 0);
    for (const auto& p : c) centre += p / static_cast<double>(n);
    Outline middles;
    for (std::size_t i = 0; i < n; ++i) middles.push_back(half(c[i], c[(i + 1) % n]));
    for (std::size_t i = 0; i < n; ++i) {
      const auto& before = middles[(i + n - 1) % n];
      add_child(n == 3 ? Outline{c[i], middles[i], before} : Outline{c[i], middles[i], centre, before});
    }
    if (n == 3) add_child(middles);
    for (bool found = true; found;) {
      found = false;
      for (std::size_t i = 0; i < leaves_.size() && !found; ++i) {
        if (leaves_[i].surface != leaf.surface || leaf.level + 1 - leaves_[i].level <= 1 ||
            !touches(leaf, leaves_[i])) {
          continue;
        }
        subdivide(i);
        found = true;
      }
    }
  }

  // Whether an edge of `fine` lies on an edge of `coarse`, but for rounding.
  static bool touches(const Leaf& fine, const Leaf& coarse) {
    for (std::size_t i = 0; i < fine.corners.size(); ++i) {
      for (std::size_t k = 0; k < coarse.corners.size(); ++k) {
        const auto &a = coarse.corners[k], &b = coarse.corners[(k + 1) % coarse.corners.size()];
        if (on(fine.corners[i], a, b) && on(fine.corners[(i + 1) % fine.corners.size()], a, b)) return true;
      }
    }
    return false;
  }
  static bool on(const geom::dvec3& p, const geom::dvec3& a, const geom::dvec3& b) {
    return geom::distance_to_segment(p, a, b) < 3;
  }

  [[nodiscard]] bool enclosed(const Leaf& leaf) const {
    for (std::size_t i = 0; i < leaf.corners.size(); ++i) {
      const auto middle = half(leaf.corners[i], leaf.corners[(i + 1) % leaf.corners.size()]);
      const bool known = std::any_of(leaves_.begin(), leaves_.end(), [&](const Leaf& other) {
        return other.surface == leaf.surface &&
               std::any_of(other.corners.begin(), other.corners.end(),
                           [&](const auto& p) { return glm::distance(p, middle) < 3; });
      });
      if (!known) return false;
    }
    return true;
  }

  std::vector<Leaf> leaves_;
};

}  // namespace rad::tests
