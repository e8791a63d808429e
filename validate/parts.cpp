#include "validate/parts.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <map>
#include <span>

#include "scene/disjoint_sets.h"

namespace rad::validate {
namespace {

struct EdgeUse {
  std::uint64_t edge = 0;  ///< the smaller end in the high half, the other in the low half
  std::uint64_t use = 0;   ///< the face, and whether it runs from the smaller end

  EdgeUse(PointId from, PointId to, FaceId face)
      : edge(std::uint64_t{std::min(from, to)} << 32 | std::max(from, to)),
        use(std::uint64_t{face} << 1 | (from < to ? 1 : 0)) {}

  [[nodiscard]] FaceId face() const { return static_cast<FaceId>(use >> 1); }
  [[nodiscard]] bool forward() const { return (use & 1) != 0; }
  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.use < b.use;
  }
};

std::vector<EdgeUse> all_uses(const Context& context) {
  std::vector<EdgeUse> uses;
  uses.reserve(context.model.corners.size());
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    if (context.model.left_out[face]) continue;
    for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
      const auto corners = context.model.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId from = corners[i], to = corners[(i + 1) % corners.size()];
        if (from != to) uses.emplace_back(from, to, face);
      }
    }
  }
  tbb::parallel_sort(uses.begin(), uses.end());
  return uses;
}

template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].edge == uses[begin].edge) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

void unite_over(std::span<const EdgeUse> uses, const Context& context, scene::DisjointSets& sets) {
  if (uses.size() == 2) return sets.unite(uses[0].face(), uses[1].face());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const scene::ObjectId object = context.object_of(uses[i].face());
    if (context.scene.objects[object].empty()) continue;
    for (std::size_t k = i + 1; k < uses.size(); ++k) {
      if (context.object_of(uses[k].face()) != object) continue;
      sets.unite(uses[i].face(), uses[k].face());
      break;
    }
  }
}

void note_open(std::span<const EdgeUse> uses, Parts& parts) {
  const bool matched = uses.size() == 2 && uses[0].forward() != uses[1].forward();
  if (matched && parts.part_of_face[uses[0].face()] == parts.part_of_face[uses[1].face()]) return;
  std::map<FaceId, int> balance;
  for (const EdgeUse& use : uses) balance[parts.part_of_face[use.face()]] += use.forward() ? 1 : -1;
  for (const auto& [part, sum] : balance) {
    if (sum != 0) parts.open[part] = true;
  }
}

}  // namespace

bool Parts::together(const Topology& topology, FaceId a, FaceId b) const {
  const FaceId part = part_of_face[a], other = part_of_face[b];
  if (part == other) return true;
  const std::uint32_t component = topology.component_of_face[a];
  const bool hang_together = component != kNoComponent && component == topology.component_of_face[b];
  return hang_together && open[part] && open[other];
}

Parts find_parts(const Context& context) {
  const std::vector<EdgeUse> uses = all_uses(context);
  const std::size_t count = context.scene.faces.size();
  scene::DisjointSets sets(count);
  for_each_edge(uses, [&](std::span<const EdgeUse> of_edge) { unite_over(of_edge, context, sets); });
  Parts parts;
  parts.part_of_face.resize(count);
  for (FaceId face = 0; face < count; ++face) parts.part_of_face[face] = sets.find(face);
  parts.open.assign(count, false);
  for_each_edge(uses, [&](std::span<const EdgeUse> of_edge) { note_open(of_edge, parts); });
  return parts;
}

}  // namespace rad::validate
