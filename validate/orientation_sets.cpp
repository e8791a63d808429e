#include "validate/orientation_sets.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "validate/neighbours.h"

namespace rad::validate {
namespace {

constexpr std::uint32_t kNoSet = 0xffffffffu;

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

// Calls visit(a, b, agree) for the neighbours at a subedge but for those that run one way and lie on each other.
template <typename Visit>
void for_each_tied_pair(const Context& context, const Subedge& subedge, Visit&& visit) {
  for_each_neighbours(context, subedge, [&](const Coedge& a, const Coedge& b) {
    const bool agree = a.forward != b.forward;
    const bool tied =
        agree || !are_parallel(context, a.face, b.face) || touching_solids(context, subedge, a.face, b.face);
    if (tied) visit(a.face, b.face, agree);
  });
}

bool has_two_faces(const Context& context, const Subedge& subedge) {
  return context.topology.coedges_of(subedge).size() == 2;
}

// Puts the faces of a set together and notes its sort; faces come ascending.
void put_in_set(FaceId face, const ParitySets::Root& root, bool orientable, std::vector<std::uint32_t>& set_of_root,
                OrientationSets& result) {
  if (set_of_root[root.member] == kNoSet) {
    set_of_root[root.member] = static_cast<std::uint32_t>(result.sets.size());
    result.sets.push_back({{}, orientable});
  }
  result.set_of_face[face] = set_of_root[root.member];
  result.parity[face] = root.parity;
  result.sets[result.set_of_face[face]].faces.push_back(face);
}

}  // namespace

OrientationSets find_orientation_sets(const Context& context) {
  const auto count = static_cast<FaceId>(context.scene.faces.size());
  ParitySets all(count), certain(count);
  for (const Subedge& subedge : context.topology.subedges) {
    const bool is_certain = has_two_faces(context, subedge);
    for_each_tied_pair(context, subedge, [&](FaceId a, FaceId b, bool agree) {
      all.join(a, b, agree);
      if (is_certain) certain.join(a, b, agree);
    });
  }
  OrientationSets result;
  result.set_of_face.resize(count);
  result.parity.resize(count);
  result.is_one_sided.resize(count, 0);
  std::vector<std::uint32_t> set_of_whole(count, kNoSet), set_of_certain(count, kNoSet);
  std::map<FaceId, std::vector<FaceId>> one_sided;
  for (FaceId face = 0; face < count; ++face) {
    const auto whole = all.find(face), own = certain.find(face);
    if (all.consistent(whole.member)) {
      put_in_set(face, whole, true, set_of_whole, result);
      continue;
    }
    one_sided[whole.member].push_back(face);
    result.is_one_sided[face] = 1;
    put_in_set(face, own, certain.consistent(own.member), set_of_certain, result);
  }
  for (auto& [first, faces] : one_sided) result.one_sided.push_back(std::move(faces));
  return result;
}

std::vector<Disagreement> disagreements_of(const Context& context) {
  std::vector<Disagreement> found;
  for (const Subedge& subedge : context.topology.subedges) {
    for_each_tied_pair(context, subedge, [&](FaceId a, FaceId b, bool agree) {
      if (!agree) found.push_back({&subedge, {a, b}});
    });
  }
  if (found.empty()) return found;
  const OrientationSets orientation = find_orientation_sets(context);
  std::erase_if(found, [&](const Disagreement& item) {
    const FaceId a = item.faces[0];  // the other one is of the same sets
    if (orientation.is_one_sided[a] == 0) return false;
    return !has_two_faces(context, *item.subedge) || !orientation.sets[orientation.set_of_face[a]].orientable;
  });
  return found;
}

}  // namespace rad::validate
