#include "repair/maximal_faces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "repair/edge_uses.h"
#include "repair/outline_loops.h"
#include "repair/texture_regions.h"
#include "scene/disjoint_sets.h"

namespace rad::repair {
namespace {

using scene::ConformingFace;
using scene::ConformingModel;

// What triangles of one face have in common; the last is the texture region.
using Likeness =
    std::tuple<ClusterId, bool, std::uint32_t, scene::MaterialId, scene::ObjectId, scene::GroupId, std::uint32_t>;

class Merger {
 public:
  Merger(const PlanarTriangles& set, const scene::Scene& scene)
      : set_(set),
        scene_(scene),
        triangles_(set.members),
        uses_(set),
        sets_(triangles_.size()),
        loops_(set.points.size()) {}

  ConformingModel run(const geom::Lattice& lattice, const geom::Tolerance& tolerance) {
    model_.lattice = lattice;
    model_.tolerance = tolerance;
    number_points();
    regions_ = texture_regions(set_, scene_, neighbours(), tolerance.length);
    unite();
    add_faces();
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

  [[nodiscard]] std::array<PointId, 2> ends_of(Side side) const {
    const auto& points = triangles_[side / 3].points;
    return {points[side % 3], points[(side + 1) % 3]};
  }
  [[nodiscard]] bool forward(Side side) const {
    const auto [from, to] = ends_of(side);
    return from < to;
  }
  [[nodiscard]] bool alike(Side a, Side b) const {
    if (triangles_[a / 3].cluster != triangles_[b / 3].cluster) return false;
    return likeness(a / 3) == likeness(b / 3);
  }

  // Nothing ends at or touches the edge where every kind of face that uses it goes on across it.
  [[nodiscard]] bool runs_through(std::span<const Side> sides) const {
    const ClusterId cluster = triangles_[sides.front() / 3].cluster;
    return std::ranges::all_of(sides, [&](Side side) {
      if (triangles_[side / 3].cluster != cluster) return false;
      std::array<int, 2> directions{0, 0};
      for (const Side other : sides) {
        if (alike(side, other)) ++directions[forward(other) ? 1 : 0];
      }
      return directions == std::array{1, 1};
    });
  }

  // Calls with the triangles at an edge that are alike, pair by pair.
  template <typename Visit>
  void for_each_like_pair(std::span<const Side> sides, Visit visit) const {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        if (alike(sides[i], sides[j])) visit(sides[i] / 3, sides[j] / 3);
      }
    }
  }

  // Before there are regions: what could become one face whatever its texture coordinates are.
  std::vector<std::array<std::uint32_t, 2>> neighbours() const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    if (scene_.attributes.texture_coordinates.empty()) return pairs;
    for (std::uint32_t edge = 0; edge < uses_.edge_count(); ++edge) {
      for_each_like_pair(uses_.on_edge(edge), [&](std::uint32_t a, std::uint32_t b) { pairs.push_back({a, b}); });
    }
    return pairs;
  }

  void unite() {
    for (std::uint32_t edge = 0; edge < uses_.edge_count(); ++edge) {
      const auto sides = uses_.on_edge(edge);
      if (sides.size() < 2 || !runs_through(sides)) continue;
      for_each_like_pair(sides, [&](std::uint32_t a, std::uint32_t b) { sets_.unite(a, b); });
    }
  }

  // All triangles as precedes() orders them: by their first point, then few at a time.
  [[nodiscard]] std::vector<std::uint32_t> in_order() const {
    std::vector<std::uint32_t> first(model_.points.size() + 1, 0);
    for (const auto& points : placed_) ++first[points[0] + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> order(placed_.size()), next = first;
    for (std::uint32_t i = 0; i < placed_.size(); ++i) order[next[placed_[i][0]]++] = i;
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
      std::sort(order.begin() + first[i], order.begin() + first[i + 1],
                [&](std::uint32_t a, std::uint32_t b) { return precedes(a, b); });
    }
    return order;
  }

  // Faces and their triangles in order: a face comes where its first triangle does.
  void add_faces() {
    const std::vector<std::uint32_t> order = in_order();
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> face_of_set(placed_.size(), kNone), face_of(placed_.size()), first{0};
    for (const std::uint32_t triangle : order) {
      std::uint32_t& face = face_of_set[sets_.find(triangle)];
      if (face == kNone) {
        face = static_cast<std::uint32_t>(first.size() - 1);
        first.push_back(0);
      }
      face_of[triangle] = face;
      ++first[face + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> members(placed_.size()), next = first;
    for (const std::uint32_t triangle : order) members[next[face_of[triangle]]++] = triangle;
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
      add_face(std::span(members).subspan(first[i], first[i + 1] - first[i]));
    }
  }

  // An order of triangles by place; the likeness tells those of one place apart.
  [[nodiscard]] bool precedes(std::uint32_t a, std::uint32_t b) const {
    if (placed_[a] != placed_[b]) return placed_[a] < placed_[b];
    return std::tuple(likeness(a), source(a)) < std::tuple(likeness(b), source(b));
  }

  // The source that most triangles came from; among equals the first.
  [[nodiscard]] scene::FaceId main_source(std::span<const std::uint32_t> members) const {
    if (members.size() == 1) return source(members.front());
    std::vector<scene::FaceId> sources;
    for (const std::uint32_t member : members) sources.push_back(source(member));
    std::sort(sources.begin(), sources.end());
    scene::FaceId best = 0;
    std::size_t best_count = 0;
    for (std::size_t first = 0, last = 0; first < sources.size(); first = last) {
      while (last < sources.size() && sources[last] == sources[first]) ++last;
      if (last - first <= best_count) continue;
      best_count = last - first;
      best = sources[first];
    }
    return best;
  }

  void add_face(std::span<const std::uint32_t> members) {
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
    for (const std::uint32_t member : members) {
      model_.triangles.push_back(placed_[member]);
      model_.origins.push_back({source(member), triangles_[member].won});
    }
    face.first_inner_edge = static_cast<std::uint32_t>(model_.inner_edges.size());
    face.first_loop = static_cast<std::uint32_t>(model_.loops.size());
    if (members.size() == 1) {
      add_loop(placed_[members.front()]);
    } else {
      add_inner_edges(members, face);
      add_loops(members, face);
    }
    face.loop_count = static_cast<std::uint32_t>(model_.loops.size()) - face.first_loop;
    model_.faces.push_back(face);
  }

  // Edges with this face on both sides that something else touches.
  void add_inner_edges(std::span<const std::uint32_t> members, ConformingFace& face) {
    const std::uint32_t root = sets_.find(members.front());
    for (const std::uint32_t member : members) {
      for (Side side = 3 * member; side < 3 * member + 3; ++side) {
        const auto [a, b] = ends_of(side);
        if (number_[a] > number_[b]) continue;
        const auto sides = uses_.between(a, b);
        const auto own = std::ranges::count_if(sides, [&](Side other) { return sets_.find(other / 3) == root; });
        if (own == 2 && !runs_through(sides)) model_.inner_edges.push_back({number_[a], number_[b]});
      }
    }
    std::sort(model_.inner_edges.begin() + face.first_inner_edge, model_.inner_edges.end());
    face.inner_edge_count = static_cast<std::uint32_t>(model_.inner_edges.size()) - face.first_inner_edge;
  }

  // What no triangle of the face runs along the other way is its outline; ascending.
  [[nodiscard]] std::vector<std::array<PointId, 2>> outline_of(std::span<const std::uint32_t> members) const {
    std::vector<std::array<PointId, 2>> directed, outline;
    for (const std::uint32_t member : members) {
      const auto& points = placed_[member];
      for (std::size_t k = 0; k < 3; ++k) directed.push_back({points[k], points[(k + 1) % 3]});
    }
    std::sort(directed.begin(), directed.end());
    for (const auto& [a, b] : directed) {
      if (!std::binary_search(directed.begin(), directed.end(), std::array{b, a})) outline.push_back({a, b});
    }
    return outline;
  }

  void add_loops(std::span<const std::uint32_t> members, const ConformingFace& face) {
    const std::vector<std::vector<PointId>> loops = loops_.of(outline_of(members));
    std::vector<double> areas;
    areas.reserve(loops.size());
    for (const auto& loop : loops) areas.push_back((face.along ? 1 : -1) * area_of(loop, set_.planes[face.plane]));
    std::vector<std::size_t> order(loops.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const bool a_outer = areas[a] > 0, b_outer = areas[b] > 0;
      return a_outer != b_outer ? a_outer : loops[a] < loops[b];
    });
    for (const std::size_t i : order) add_loop(loops[i]);
  }

  void add_loop(std::span<const PointId> loop) {
    model_.loops.push_back(
        {static_cast<std::uint32_t>(model_.corners.size()), static_cast<std::uint32_t>(loop.size())});
    model_.corners.insert(model_.corners.end(), loop.begin(), loop.end());
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
  const EdgeUses uses_;
  scene::DisjointSets sets_;
  std::vector<PointId> number_;
  std::vector<std::array<PointId, 3>> placed_;  ///< per triangle: its corners in their new numbers, the least first
  std::vector<std::uint32_t> regions_;          ///< per triangle; empty without texture coordinates
  OutlineLoops loops_;
  ConformingModel model_;
};

}  // namespace

scene::ConformingModel maximal_faces(const PlanarTriangles& triangles, const scene::Scene& scene,
                                     const geom::Lattice& lattice, const geom::Tolerance& tolerance) {
  return Merger(triangles, scene).run(lattice, tolerance);
}

}  // namespace rad::repair
