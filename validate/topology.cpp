#include "validate/topology.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <numeric>

#include "scene/disjoint_sets.h"

namespace rad::validate {
namespace {

using scene::DisjointSets;
using scene::LatticeModel;
using scene::Loop;
using scene::Scene;

struct Use {
  std::uint64_t key = 0;  ///< a in the high half, b in the low half
  FaceId face = 0;
  bool forward = true;

  friend bool operator<(const Use& x, const Use& y) {
    return std::tie(x.key, x.face, x.forward) < std::tie(y.key, y.face, y.forward);
  }
};

bool takes_part(FaceCondition condition) {
  return condition == FaceCondition::Sound || condition == FaceCondition::RingCrosses;
}

// Greedy independent set over "within T", smallest position first: survivors are more than T apart, everyone else moves
// to the nearest survivor. One hop, so nothing drifts along a chain of near vertices.
std::vector<PointId> representatives(const LatticeModel& model, const std::vector<NearVertices>& near) {
  std::vector<PointId> representative(model.points.size());
  std::iota(representative.begin(), representative.end(), 0u);
  std::map<PointId, std::vector<PointId>> neighbours;
  for (const NearVertices& pair : near) {
    neighbours[pair.a].push_back(pair.b);
    neighbours[pair.b].push_back(pair.a);
  }
  std::map<PointId, bool> survives;
  for (const auto& [point, others] : neighbours) {
    survives[point] = std::none_of(others.begin(), others.end(), [&survives, self = point](PointId other) {
      return other < self && survives[other];
    });
  }
  for (const auto& [point, others] : neighbours) {
    if (survives[point]) continue;
    PointId nearest = point;
    std::int64_t best = 0;
    for (const PointId other : others) {
      if (!survives[other]) continue;
      const std::int64_t distance = geom::squared_distance(model.points[point], model.points[other]);
      if (nearest == point || distance < best || (distance == best && other < nearest)) {
        nearest = other;
        best = distance;
      }
    }
    representative[point] = nearest;
  }
  return representative;
}

/// Runs along the loops of faces and writes every stretch between neighbouring vertices.
class EdgeWalk {
 public:
  EdgeWalk(const LatticeModel& model, const Contacts& contacts, const std::vector<PointId>& representative)
      : model_(model), representative_(representative) {
    for (const VertexOnEdge& event : contacts.vertices_on_edges) {
      if (insertions_.empty() || insertions_.back().edge != event.edge || insertions_.back().vertex != event.vertex) {
        insertions_.push_back(event);
      }
    }
  }

  void walk(FaceId face, std::span<const PointId> corners, std::vector<Use>& uses) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const PointId from = corners[i], to = corners[(i + 1) % corners.size()];
      PointId here = representative_[from];
      for (const PointId next : between(from, to)) add(face, here, representative_[next], uses);
      add(face, here, representative_[to], uses);
    }
  }

 private:
  static void add(FaceId face, PointId& here, PointId next, std::vector<Use>& uses) {
    if (here == next) return;
    const bool forward = here < next;
    const std::uint64_t low = std::min(here, next), high = std::max(here, next);
    uses.push_back({low << 32 | high, face, forward});
    here = next;
  }

  std::vector<PointId> between(PointId from, PointId to) const {
    std::vector<PointId> result;
    if (insertions_.empty()) return result;
    const std::array<PointId, 2> edge{std::min(from, to), std::max(from, to)};
    auto at = std::lower_bound(insertions_.begin(), insertions_.end(), edge,
                               [](const VertexOnEdge& event, const auto& wanted) { return event.edge < wanted; });
    for (; at != insertions_.end() && at->edge == edge; ++at) result.push_back(at->vertex);
    const geom::LatticePoint& start = model_.points[from];
    const geom::IntVector along = geom::difference(model_.points[to], start);
    std::sort(result.begin(), result.end(), [&](PointId x, PointId y) {
      const auto reach = [&](PointId id) { return geom::dot(along, geom::difference(model_.points[id], start)); };
      return reach(x) != reach(y) ? reach(x) < reach(y) : x < y;
    });
    return result;
  }

  const LatticeModel& model_;
  const std::vector<PointId>& representative_;
  std::vector<VertexOnEdge> insertions_;
};

std::vector<Use> all_uses(const Scene& scene, const LatticeModel& model, const FaceTriangles& triangles,
                          const EdgeWalk& walk) {
  constexpr std::size_t kFacesPerBlock = 8192;
  const std::size_t count = scene.faces.size();
  std::vector<std::vector<Use>> blocks((count + kFacesPerBlock - 1) / kFacesPerBlock);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    for (std::size_t id = b * kFacesPerBlock; id < std::min(count, (b + 1) * kFacesPerBlock); ++id) {
      if (!takes_part(triangles.condition[id])) continue;
      for (const Loop& loop : scene.loops_of(scene.faces[id])) {
        walk.walk(static_cast<FaceId>(id), model.corners_of(loop), blocks[b]);
      }
    }
  });
  std::vector<Use> uses;
  for (auto& block : blocks) {
    uses.insert(uses.end(), block.begin(), block.end());
    block = {};
  }
  tbb::parallel_sort(uses.begin(), uses.end());
  return uses;
}

// Drops pairs of opposite uses of a subedge by one face: bridges and antennas separate nothing.
void keep_unpaired(std::span<const Use> uses, std::vector<Coedge>& coedges) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i;
    int balance = 0;
    while (end < uses.size() && uses[end].face == uses[i].face) balance += uses[end++].forward ? 1 : -1;
    for (int k = 0; k < std::abs(balance); ++k) coedges.push_back({uses[i].face, balance > 0});
    i = end;
  }
}

void group_subedges(std::span<const Use> uses, Topology& topology) {
  topology.coedges.reserve(uses.size());
  topology.subedges.reserve(uses.size() / 2);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i;
    while (end < uses.size() && uses[end].key == uses[i].key) ++end;
    Subedge subedge{static_cast<PointId>(uses[i].key >> 32), static_cast<PointId>(uses[i].key & 0xffffffffu),
                    static_cast<std::uint32_t>(topology.coedges.size()), 0};
    keep_unpaired(uses.subspan(i, end - i), topology.coedges);
    subedge.count = static_cast<std::uint32_t>(topology.coedges.size()) - subedge.first;
    if (subedge.count > 0) topology.subedges.push_back(subedge);
    i = end;
  }
}

// Faces that a subedge joins to one component: all where there are two, else those of the same object.
void unite_over(std::span<const Coedge> coedges, const Scene& scene, DisjointSets& sets) {
  if (coedges.size() == 2) {
    sets.unite(coedges[0].face, coedges[1].face);
    return;
  }
  for (std::size_t i = 0; i < coedges.size(); ++i) {
    for (std::size_t j = i + 1; j < coedges.size(); ++j) {
      if (scene.faces[coedges[i].face].object == scene.faces[coedges[j].face].object) {
        sets.unite(coedges[i].face, coedges[j].face);
        break;
      }
    }
  }
}

bool smooth_across(const Coedge& a, const Coedge& b, const Scene& scene, const FaceTriangles& triangles) {
  static const double kSmoothCosine = std::cos(kSmoothAngleDegrees * std::numbers::pi / 180);
  if (a.forward == b.forward || scene.faces[a.face].material != scene.faces[b.face].material) return false;
  const geom::dvec3& m = triangles.normal[a.face];
  const geom::dvec3& n = triangles.normal[b.face];
  return glm::dot(m, n) >= kSmoothCosine * glm::length(m) * glm::length(n);
}

void find_surfaces(const Scene& scene, const FaceTriangles& triangles, Topology& topology) {
  DisjointSets sets(scene.faces.size());
  for (const Subedge& subedge : topology.subedges) {
    const auto coedges = topology.coedges_of(subedge);
    if (coedges.size() == 2 && smooth_across(coedges[0], coedges[1], scene, triangles)) {
      sets.unite(coedges[0].face, coedges[1].face);
    }
  }
  topology.surface_of_face.resize(scene.faces.size());
  for (FaceId id = 0; id < scene.faces.size(); ++id) topology.surface_of_face[id] = sets.find(id);
}

// Numbers components by their smallest point.
void number_components(const Scene& scene, const LatticeModel& model, const FaceTriangles& triangles,
                       DisjointSets& sets, Topology& topology) {
  std::map<FaceId, PointId> smallest;
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    if (!takes_part(triangles.condition[id])) continue;
    PointId least = scene::kNoPoint;
    for (const Loop& loop : scene.loops_of(scene.faces[id])) {
      for (const PointId p : model.corners_of(loop)) least = std::min(least, p);
    }
    const auto [entry, fresh] = smallest.emplace(sets.find(id), least);
    if (!fresh) entry->second = std::min(entry->second, least);
  }
  std::vector<std::pair<PointId, FaceId>> order;
  for (const auto& [root, point] : smallest) order.emplace_back(point, root);
  std::sort(order.begin(), order.end());
  std::map<FaceId, std::uint32_t> number;
  for (const auto& [point, root] : order) number.emplace(root, static_cast<std::uint32_t>(number.size()));
  topology.components.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) topology.components[i].smallest_point = order[i].first;
  topology.component_of_face.assign(scene.faces.size(), kNoComponent);
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    if (takes_part(triangles.condition[id])) topology.component_of_face[id] = number[sets.find(id)];
  }
}

void grow(Component& component, const geom::LatticePoint& p, bool first) {
  if (first) component.low = component.high = p;
  component.low = {std::min(component.low.x, p.x), std::min(component.low.y, p.y), std::min(component.low.z, p.z)};
  component.high = {std::max(component.high.x, p.x), std::max(component.high.y, p.y), std::max(component.high.z, p.z)};
}

void measure_faces(const Scene& scene, const LatticeModel& model, const FaceTriangles& triangles, Topology& topology) {
  for (FaceId id = 0; id < scene.faces.size(); ++id) {
    if (topology.component_of_face[id] == kNoComponent) continue;
    Component& component = topology.components[topology.component_of_face[id]];
    bool first = component.faces++ == 0;
    component.area += glm::length(triangles.normal[id]) / 2;
    for (const Loop& loop : scene.loops_of(scene.faces[id])) {
      for (const PointId p : model.corners_of(loop)) {
        grow(component, model.points[p], first);
        first = false;
      }
    }
  }
  for (std::size_t i = 0; i < triangles.triangles.size(); ++i) {
    const geom::LatticePoint& a = triangles.geometry[i].points[0];
    const auto& plane = triangles.geometry[i].plane;
    Component& component = topology.components[topology.component_of_face[triangles.triangles[i].face]];
    component.volume6 += geom::dot(plane.normal, geom::difference(a, component.low));
  }
}

void measure_edges(const LatticeModel& model, Topology& topology) {
  for (const Subedge& subedge : topology.subedges) {
    const auto coedges = topology.coedges_of(subedge);
    const bool matched = coedges.size() == 2 && coedges[0].forward != coedges[1].forward;
    if (matched) {  // two coedges always belong to one component
      ++topology.components[topology.component_of_face[coedges[0].face]].subedges;
      continue;
    }
    std::map<std::uint32_t, std::pair<int, int>> uses;  // component → uses, balance
    for (const Coedge& coedge : coedges) {
      auto& [count, balance] = uses[topology.component_of_face[coedge.face]];
      ++count;
      balance += coedge.forward ? 1 : -1;
    }
    for (const auto& [id, use] : uses) {
      Component& component = topology.components[id];
      ++component.subedges;
      if (use.second != 0) component.balanced = false;
      if (use.first != 1) continue;
      ++component.open_subedges;
      const auto squared = geom::squared_distance(model.points[subedge.a], model.points[subedge.b]);
      component.open_length += std::sqrt(static_cast<double>(squared));
    }
  }
}

}  // namespace

Topology build_topology(const Scene& scene, const LatticeModel& model, const FaceTriangles& triangles,
                        const Contacts& contacts) {
  Topology topology;
  topology.representative = representatives(model, contacts.near_vertices);
  const EdgeWalk walk(model, contacts, topology.representative);
  group_subedges(all_uses(scene, model, triangles, walk), topology);
  DisjointSets sets(scene.faces.size());
  for (const Subedge& subedge : topology.subedges) unite_over(topology.coedges_of(subedge), scene, sets);
  number_components(scene, model, triangles, sets, topology);
  measure_faces(scene, model, triangles, topology);
  measure_edges(model, topology);
  find_surfaces(scene, triangles, topology);
  return topology;
}

}  // namespace rad::validate
