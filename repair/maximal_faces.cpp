#include "repair/maximal_faces.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "repair/texture_regions.h"
#include "scene/disjoint_sets.h"

namespace rad::repair {
namespace {

using scene::ConformingFace;
using scene::ConformingModel;

// What triangles of one face have in common; the last is the texture region.
using Likeness =
    std::tuple<ClusterId, bool, std::uint32_t, scene::MaterialId, scene::ObjectId, scene::GroupId, std::uint32_t>;

struct Use {
  EdgeKey edge = 0;
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
  friend constexpr auto operator<=>(const Use&, const Use&) = default;
};

class Merger {
 public:
  Merger(const PlanarTriangles& set, const scene::Scene& scene)
      : set_(set), scene_(scene), triangles_(set.members), sets_(triangles_.size()) {}

  ConformingModel run(const geom::Lattice& lattice, const geom::Tolerance& tolerance) {
    model_.lattice = lattice;
    model_.tolerance = tolerance;
    number_points();
    gather_uses();
    regions_ = texture_regions(set_, scene_, neighbours(), tolerance.length);
    unite();
    for (const auto& members : members_of_faces()) add_face(members);
    return std::move(model_);
  }

 private:
  [[nodiscard]] scene::FaceId source(std::uint32_t triangle) const { return triangles_[triangle].source; }

  [[nodiscard]] Likeness likeness(std::uint32_t triangle) const {
    const PlanarTriangles::Member& t = triangles_[triangle];
    const scene::Face& face = scene_.faces[source(triangle)];
    const std::uint32_t region = regions_.empty() ? 0 : regions_[triangle];
    return {t.cluster, t.along, t.layer, face.material, face.object, face.group, region};
  }

  void number_points() {
    std::vector<PointId> used;
    for (const auto& triangle : triangles_) used.insert(used.end(), triangle.points.begin(), triangle.points.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::sort(used.begin(), used.end(), [&](PointId a, PointId b) { return set_.points[a] < set_.points[b]; });
    number_.assign(set_.points.size(), scene::kNoPoint);
    for (const PointId id : used) {
      number_[id] = static_cast<PointId>(model_.points.size());
      model_.points.push_back(set_.points[id]);
    }
    for (const PlanarTriangles::Member& triangle : triangles_) {
      std::array<PointId, 3>& points = placed_.emplace_back();
      std::ranges::transform(triangle.points, points.begin(), [&](PointId id) { return number_[id]; });
      std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    }
  }

  void gather_uses() {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        uses_.push_back({edge_key(triangles_[i].points[k], triangles_[i].points[(k + 1) % 3]), i, k});
      }
    }
    std::sort(uses_.begin(), uses_.end());
  }

  [[nodiscard]] bool forward(const Use& use) const {
    return triangles_[use.triangle].points[use.corner] == first_end(use.edge);
  }
  static PointId first_end(EdgeKey edge) { return ends_of(edge)[0]; }

  // Nothing ends at or touches the edge where every kind of face that uses it goes on across it.
  [[nodiscard]] bool runs_through(std::span<const Use> uses) const {
    std::map<Likeness, std::array<int, 2>> kinds;
    for (const Use& use : uses) ++kinds[likeness(use.triangle)][forward(use) ? 1 : 0];
    const ClusterId cluster = triangles_[uses.front().triangle].cluster;
    return std::ranges::all_of(kinds, [&](const auto& entry) {
      return std::get<0>(entry.first) == cluster && entry.second == std::array{1, 1};
    });
  }

  // Calls with the uses of each edge, in order.
  template <typename Visit>
  void for_each_edge(Visit visit) const {
    for (std::size_t first = 0, last = 0; first < uses_.size(); first = last) {
      while (last < uses_.size() && uses_[last].edge == uses_[first].edge) ++last;
      visit(std::span(uses_.data() + first, last - first));
    }
  }

  // Calls with the triangles at an edge that are alike, pair by pair.
  template <typename Visit>
  void for_each_like_pair(std::span<const Use> uses, Visit visit) const {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      for (std::size_t j = i + 1; j < uses.size(); ++j) {
        if (likeness(uses[i].triangle) == likeness(uses[j].triangle)) visit(uses[i].triangle, uses[j].triangle);
      }
    }
  }

  // Before there are regions: what could become one face whatever its texture coordinates are.
  std::vector<std::array<std::uint32_t, 2>> neighbours() const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    if (scene_.attributes.texture_coordinates.empty()) return pairs;
    for_each_edge([&](std::span<const Use> uses) {
      for_each_like_pair(uses, [&](std::uint32_t a, std::uint32_t b) { pairs.push_back({a, b}); });
    });
    return pairs;
  }

  void unite() {
    for_each_edge([&](std::span<const Use> uses) {
      if (!runs_through(uses)) return;
      for_each_like_pair(uses, [&](std::uint32_t a, std::uint32_t b) { sets_.unite(a, b); });
    });
  }

  std::vector<std::vector<std::uint32_t>> members_of_faces() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) groups[sets_.find(i)].push_back(i);
    std::vector<std::vector<std::uint32_t>> faces;
    faces.reserve(groups.size());
    for (auto& [root, members] : groups) {
      std::ranges::sort(members, [&](std::uint32_t a, std::uint32_t b) { return precedes(a, b); });
      faces.push_back(std::move(members));
    }
    std::ranges::sort(faces, [&](const auto& a, const auto& b) { return precedes(a.front(), b.front()); });
    return faces;
  }

  // An order of triangles by place; the likeness tells those of one place apart.
  [[nodiscard]] bool precedes(std::uint32_t a, std::uint32_t b) const {
    if (placed_[a] != placed_[b]) return placed_[a] < placed_[b];
    return std::tuple(likeness(a), source(a)) < std::tuple(likeness(b), source(b));
  }

  // The source that most triangles came from; among equals the first.
  [[nodiscard]] scene::FaceId main_source(const std::vector<std::uint32_t>& members) const {
    std::map<scene::FaceId, std::size_t> counts;
    for (const std::uint32_t member : members) ++counts[source(member)];
    return std::ranges::max_element(counts, [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  }

  void add_face(const std::vector<std::uint32_t>& members) {
    ConformingFace face;
    face.source = main_source(members);
    const scene::Face& origin = scene_.faces[face.source];
    face.material = origin.material;
    face.object = origin.object;
    face.group = origin.group;
    face.plane = triangles_[members.front()].cluster;
    face.along = triangles_[members.front()].along;
    face.first_triangle = static_cast<std::uint32_t>(model_.triangles.size());
    face.triangle_count = static_cast<std::uint32_t>(members.size());
    std::vector<std::array<PointId, 2>> directed;
    for (const std::uint32_t member : members) {
      const std::array<PointId, 3>& points = placed_[member];
      model_.triangles.push_back(points);
      model_.origins.push_back({source(member), triangles_[member].won});
      for (std::size_t k = 0; k < 3; ++k) directed.push_back({points[k], points[(k + 1) % 3]});
    }
    add_inner_edges(members, face);
    add_loops(std::move(directed), set_.planes[face.plane], face.along, face);
    model_.faces.push_back(face);
  }

  // Edges with this face on both sides that something else touches.
  void add_inner_edges(const std::vector<std::uint32_t>& members, ConformingFace& face) {
    face.first_inner_edge = static_cast<std::uint32_t>(model_.inner_edges.size());
    const std::uint32_t root = sets_.find(members.front());
    for (const std::uint32_t member : members) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const PointId a = triangles_[member].points[k], b = triangles_[member].points[(k + 1) % 3];
        const auto uses = uses_of(edge_key(a, b));
        if (number_[a] > number_[b] || runs_through(uses)) continue;
        const bool both_sides =
            std::ranges::count_if(uses, [&](const Use& use) { return sets_.find(use.triangle) == root; }) == 2;
        if (both_sides) model_.inner_edges.push_back({number_[a], number_[b]});
      }
    }
    std::sort(model_.inner_edges.begin() + face.first_inner_edge, model_.inner_edges.end());
    face.inner_edge_count = static_cast<std::uint32_t>(model_.inner_edges.size()) - face.first_inner_edge;
  }

  [[nodiscard]] std::span<const Use> uses_of(EdgeKey edge) const {
    const auto range = std::ranges::equal_range(uses_, edge, {}, &Use::edge);
    return {range.begin(), range.end()};
  }

  // What no triangle of the face runs along the other way is its outline.
  void add_loops(std::vector<std::array<PointId, 2>> directed, const Plane& plane, bool along, ConformingFace& face) {
    std::sort(directed.begin(), directed.end());
    std::multimap<PointId, PointId> next;
    for (const auto& [a, b] : directed) {
      if (!std::binary_search(directed.begin(), directed.end(), std::array{b, a})) next.emplace(a, b);
    }
    std::vector<std::vector<PointId>> loops;
    while (!next.empty()) take_chain(next, loops);
    std::vector<double> areas;
    areas.reserve(loops.size());
    for (const auto& loop : loops) areas.push_back((along ? 1 : -1) * area_of(loop, plane));
    std::vector<std::size_t> order(loops.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const bool a_outer = areas[a] > 0, b_outer = areas[b] > 0;
      return a_outer != b_outer ? a_outer : loops[a] < loops[b];
    });
    face.first_loop = static_cast<std::uint32_t>(model_.loops.size());
    face.loop_count = static_cast<std::uint32_t>(loops.size());
    for (const std::size_t i : order) {
      model_.loops.push_back(
          {static_cast<std::uint32_t>(model_.corners.size()), static_cast<std::uint32_t>(loops[i].size())});
      model_.corners.insert(model_.corners.end(), loops[i].begin(), loops[i].end());
    }
  }

  // Follows the outline from its least point; where the chain comes back to a point, what lies between is a loop.
  static void take_chain(std::multimap<PointId, PointId>& next, std::vector<std::vector<PointId>>& loops) {
    std::vector<PointId> chain{next.begin()->first};
    while (true) {
      const auto step = next.find(chain.back());
      if (step == next.end()) break;
      const PointId to = step->second;
      next.erase(step);
      const auto seen = std::find(chain.begin(), chain.end(), to);
      if (seen == chain.end()) {
        chain.push_back(to);
        continue;
      }
      std::vector<PointId> loop(seen, chain.end());
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
      loops.push_back(std::move(loop));
      chain.erase(seen + 1, chain.end());
    }
  }

  [[nodiscard]] double area_of(const std::vector<PointId>& loop, const Plane& plane) const {
    geom::Int128 twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto a = plane.project(model_.points[loop[i]]);
      const auto b = plane.project(model_.points[loop[(i + 1) % loop.size()]]);
      twice += geom::Int128{a.u} * b.v - geom::Int128{b.u} * a.v;
    }
    return static_cast<double>(twice) / 2;
  }

  const PlanarTriangles& set_;
  const scene::Scene& scene_;
  const std::vector<PlanarTriangles::Member>& triangles_;
  scene::DisjointSets sets_;
  std::vector<PointId> number_;
  std::vector<std::array<PointId, 3>> placed_;  ///< per triangle: its corners in their new numbers, the least first
  std::vector<Use> uses_;
  std::vector<std::uint32_t> regions_;  ///< per triangle; empty without texture coordinates
  ConformingModel model_;
};

}  // namespace

scene::ConformingModel maximal_faces(const PlanarTriangles& triangles, const scene::Scene& scene,
                                     const geom::Lattice& lattice, const geom::Tolerance& tolerance) {
  return Merger(triangles, scene).run(lattice, tolerance);
}

}  // namespace rad::repair
