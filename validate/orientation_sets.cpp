#include "validate/orientation_sets.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "validate/neighbours.h"

namespace rad::validate {
namespace {

/// Union-find that knows of each member whether it agrees with its representative, the smallest of its set.
class ParitySets {
 public:
  explicit ParitySets(std::size_t count) : parent_(count), parity_(count, 0), consistent_(count, true) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  struct Root {
    std::uint32_t member = 0;
    std::uint8_t parity = 0;
  };

  Root find(std::uint32_t member) {
    Root root{member, 0};
    while (parent_[root.member] != root.member) {
      root.parity ^= parity_[root.member];
      root.member = parent_[root.member];
    }
    // Once more, so that the next way is short.
    for (std::uint8_t parity = root.parity; parent_[member] != member;) {
      const std::uint32_t next = parent_[member];
      const std::uint8_t step = parity_[member];
      parent_[member] = root.member;
      parity_[member] = parity;
      parity ^= step;
      member = next;
    }
    return root;
  }

  void join(std::uint32_t a, std::uint32_t b, bool agree) {
    Root x = find(a), y = find(b);
    const auto parity = static_cast<std::uint8_t>(x.parity ^ y.parity ^ (agree ? 0 : 1));
    if (x.member == y.member) {
      if (parity != 0) consistent_[x.member] = false;
      return;
    }
    if (x.member > y.member) std::swap(x, y);
    parent_[y.member] = x.member;
    parity_[y.member] = parity;
    consistent_[x.member] = consistent_[x.member] && consistent_[y.member];
  }

  [[nodiscard]] bool consistent(std::uint32_t root) const { return consistent_[root]; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> parity_;  ///< against the parent
  std::vector<bool> consistent_;      ///< of roots
};

bool are_parallel(const Context& context, FaceId a, FaceId b) {
  const auto &n = context.triangles.normal[a], &m = context.triangles.normal[b];
  return glm::dot(n, m) >= geom::kParallelCosine * glm::length(n) * glm::length(m);
}

// The common face of two solids of one object, each with another face at the edge. A face that is there twice, with
// nothing else of its object at the edge, is no such thing.
bool touching_solids(const Context& context, const Subedge& subedge, FaceId a, FaceId b) {
  const auto of_object = std::ranges::count_if(context.topology.coedges_of(subedge), [&](const Coedge& coedge) {
    return context.object_of(coedge.face) == context.object_of(a);
  });
  return of_object == 4 && have_the_same_corners(context, a, b);
}

}  // namespace

OrientationSets find_orientation_sets(const Context& context) {
  const auto count = static_cast<FaceId>(context.scene.faces.size());
  ParitySets parities(count);
  for (const Subedge& subedge : context.topology.subedges) {
    for_each_neighbours(context, subedge, [&](const Coedge& a, const Coedge& b) {
      const bool agree = a.forward != b.forward;
      const bool joined =
          agree || !are_parallel(context, a.face, b.face) || touching_solids(context, subedge, a.face, b.face);
      if (joined) parities.join(a.face, b.face, agree);
    });
  }
  OrientationSets result;
  result.set_of_face.resize(count);
  result.parity.resize(count);
  for (FaceId face = 0; face < count; ++face) {
    const auto root = parities.find(face);
    if (root.member == face) {
      result.set_of_face[face] = static_cast<std::uint32_t>(result.sets.size());
      result.sets.push_back({{}, parities.consistent(face)});
    }
    result.set_of_face[face] = result.set_of_face[root.member];
    result.parity[face] = root.parity;
    result.sets[result.set_of_face[face]].faces.push_back(face);
  }
  return result;
}

std::vector<Disagreement> disagreements_of(const Context& context) {
  std::vector<Disagreement> found;
  for (const Subedge& subedge : context.topology.subedges) {
    for_each_neighbours(context, subedge, [&](const Coedge& a, const Coedge& b) {
      if (a.forward == b.forward) found.push_back({&subedge, {a.face, b.face}});
    });
  }
  if (found.empty()) return found;
  const OrientationSets orientation = find_orientation_sets(context);
  std::erase_if(found, [&](const Disagreement& item) {
    const std::uint32_t set = orientation.set_of_face[item.faces[0]];
    return set == orientation.set_of_face[item.faces[1]] && !orientation.sets[set].orientable;
  });
  return found;
}

}  // namespace rad::validate
