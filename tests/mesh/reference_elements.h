// The element library by other means: leaves in a table of directed edges between places, without trees; refined by the
// paper's recursion (3.4.2). Places must stay whole numbers.
#pragma once

#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "mesh/element_mesh.h"

namespace rad::tests {

class ReferenceElements {
 public:
  using Place = std::uint64_t;
  using Ring = std::vector<Place>;

  static Place place(const geom::LatticePoint& p) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x)) << 32 | static_cast<std::uint32_t>(p.y);
  }

  void add(Ring ring, int level = 0) {
    const auto leaf = static_cast<std::uint32_t>(leaves_.size());
    for (std::size_t i = 0; i < ring.size(); ++i) edges_[{ring[i], ring[(i + 1) % ring.size()]}] = leaf;
    leaves_.push_back({std::move(ring), level, true});
  }

  /// The leaf with these corners is divided, coarser neighbours first; then every leaf with a middle on all its edges.
  void refine(const Ring& ring) {
    const auto leaf = edges_.find({ring[0], ring[1]});
    if (leaf == edges_.end() || leaves_[leaf->second].ring.size() != ring.size()) return;
    divided_.clear();
    subdivide(leaf->second);
    const std::vector<Ring> divided = divided_;
    for (const Ring& done : divided) {
      for (std::size_t i = 0; i < done.size(); ++i) {
        const auto other = edges_.find({done[(i + 1) % done.size()], done[i]});
        if (other != edges_.end() && enclosed(other->second)) subdivide(other->second);
      }
    }
  }

  [[nodiscard]] std::set<Ring> leaves() const {
    std::set<Ring> rings;
    for (const Leaf& leaf : leaves_) {
      if (leaf.alive) rings.insert(from_least(leaf.ring));
    }
    return rings;
  }

  static Ring from_least(Ring ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
  }

 private:
  struct Leaf {
    Ring ring;
    int level;
    bool alive;
  };
  using Edge = std::pair<Place, Place>;
  struct Hash {
    std::size_t operator()(const Edge& edge) const {
      return (edge.first * 0x9e3779b97f4a7c15ULL) ^ (edge.second * 0xc2b2ae3d27d4eb4fULL >> 7);
    }
  };

  static Place middle(Place a, Place b) {
    const std::uint64_t x = ((a >> 32) + (b >> 32)) / 2, y = ((a & 0xffffffffU) + (b & 0xffffffffU)) / 2;
    return x << 32 | y;
  }
  // The other half of the edge that a..b is a half of, both ways.
  static std::array<Edge, 2> doubled(Place a, Place b) {
    const auto beyond = [](Place from, Place to) {
      const std::uint64_t x = 2 * (to >> 32) - (from >> 32), y = 2 * (to & 0xffffffffU) - (from & 0xffffffffU);
      return x << 32 | (y & 0xffffffffU);
    };
    return {Edge{beyond(a, b), a}, Edge{b, beyond(b, a)}};
  }

  void subdivide(std::uint32_t index) {
    const Leaf leaf = leaves_[index];
    const std::size_t n = leaf.ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Place a = leaf.ring[i], b = leaf.ring[(i + 1) % n];
      if (edges_.contains({b, a})) continue;
      for (const Edge& coarse : doubled(a, b)) {
        const auto other = edges_.find(coarse);
        if (other != edges_.end() && leaves_[other->second].level == leaf.level - 1) {
          subdivide(other->second);
          break;
        }
      }
    }
    leaves_[index].alive = false;
    divided_.push_back(leaf.ring);
    Ring middles;
    for (std::size_t i = 0; i < n; ++i) {
      edges_.erase({leaf.ring[i], leaf.ring[(i + 1) % n]});
      middles.push_back(middle(leaf.ring[i], leaf.ring[(i + 1) % n]));
    }
    const Place centre = middle(leaf.ring[0], leaf.ring[2 % n]);
    for (std::size_t i = 0; i < n; ++i) {
      const Place before = middles[(i + n - 1) % n];
      add(n == 3 ? Ring{leaf.ring[i], middles[i], before} : Ring{leaf.ring[i], middles[i], centre, before},
          leaf.level + 1);
    }
    if (n == 3) add(middles, leaf.level + 1);
  }

  [[nodiscard]] bool enclosed(std::uint32_t index) const {
    const Leaf& leaf = leaves_[index];
    for (std::size_t i = 0; i < leaf.ring.size(); ++i) {
      const Place a = leaf.ring[i], b = leaf.ring[(i + 1) % leaf.ring.size()];
      if (!edges_.contains({b, middle(a, b)})) return false;
    }
    return true;
  }

  std::vector<Leaf> leaves_;
  std::unordered_map<Edge, std::uint32_t, Hash> edges_;
  std::vector<Ring> divided_;
};

}  // namespace rad::tests
