#include "repair/planar_caps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "validate/context.h"

namespace rad::repair {
namespace {

using geom::dvec3;
using geom::LatticePoint;
using scene::FaceId;
using scene::PointId;
using validate::Context;

/// A closed chain of border edges of one component, in the order in which a cap runs along it.
struct Border {
  std::uint32_t component = 0;
  std::vector<PointId> points;
  std::vector<FaceId> faces;  ///< beside its edges
  dvec3 normal{0, 0, 0};      ///< Newell: twice the area, pitches²
};

class Borders {
 public:
  explicit Borders(const Context& context) : context_(context) {}

  std::vector<Border> run() {
    for (const validate::Subedge& subedge : context_.topology.subedges) note(subedge);
    std::vector<Border> borders;
    for (auto& [component, steps] : steps_) follow(component, steps, borders);
    return borders;
  }

 private:
  struct Step {
    PointId to = 0;
    FaceId face = 0;
  };
  using Steps = std::multimap<PointId, Step>;

  void note(const validate::Subedge& subedge) {
    std::map<std::uint32_t, std::vector<validate::Coedge>> uses;
    const auto coedges = context_.topology.coedges_of(subedge);
    if (coedges.size() == 2) return;
    for (const auto& coedge : coedges) uses[context_.topology.component_of_face[coedge.face]].push_back(coedge);
    for (const auto& [component, own] : uses) {
      if (own.size() != 1) continue;
      const bool forward = own[0].forward;  // of the face; the cap runs the other way
      steps_[component].emplace(forward ? subedge.b : subedge.a, Step{forward ? subedge.a : subedge.b, own[0].face});
    }
  }

  // Chains from their least point on; a chain through a point at which the border branches is none.
  static void follow(std::uint32_t component, Steps& steps, std::vector<Border>& borders) {
    while (!steps.empty()) {
      Border border;
      border.component = component;
      const PointId first = steps.begin()->first;
      PointId here = first;
      bool branches = false;
      do {
        const auto range = steps.equal_range(here);
        if (range.first == range.second) break;
        branches |= std::next(range.first) != range.second;
        border.points.push_back(here);
        border.faces.push_back(range.first->second.face);
        here = range.first->second.to;
        steps.erase(range.first);
      } while (here != first);
      if (here == first && !branches && border.points.size() >= 3) borders.push_back(std::move(border));
    }
  }

  const Context& context_;
  std::map<std::uint32_t, Steps> steps_;
};

class Capper {
 public:
  Capper(scene::Scene& scene, const Context& context) : scene_(scene), context_(context) {
    vertex_of_point_.assign(context.model.points.size(), 0);
    for (scene::VertexId v = static_cast<scene::VertexId>(context.model.point_of_vertex.size()); v-- > 0;) {
      const PointId point = context.model.point_of_vertex[v];
      if (point != scene::kNoPoint) vertex_of_point_[point] = v;
    }
  }

  std::size_t run() {
    std::vector<Border> borders = Borders(context_).run();
    std::erase_if(borders, [&](Border& border) { return !measure(border) || would_double_a_sheet(border); });
    std::vector<bool> is_hole(borders.size(), false);
    std::vector<std::vector<std::size_t>> holes(borders.size());
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (const auto around = smallest_around(borders, i)) {
        is_hole[i] = true;
        holes[*around].push_back(i);
      }
    }
    std::size_t caps = 0;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (is_hole[i]) continue;
      add_cap(borders, i, holes[i]);
      ++caps;
    }
    return caps;
  }

 private:
  [[nodiscard]] dvec3 place(PointId point) const { return geom::as_vector(context_.model.points[point]); }
  [[nodiscard]] double tolerance() const { return static_cast<double>(context_.tolerance.pitches); }

  // Whether the border lies within T of the plane through its middle across its normal.
  [[nodiscard]] bool measure(Border& border) const {
    dvec3 middle(0, 0, 0);
    const std::size_t count = border.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 p = place(border.points[i]) - place(border.points[0]);
      border.normal += glm::cross(p, place(border.points[(i + 1) % count]) - place(border.points[0]));
      middle += p / static_cast<double>(count);
    }
    middle += place(border.points[0]);
    const double length = glm::length(border.normal);
    if (length == 0) return false;
    return std::ranges::all_of(border.points, [&](PointId point) {
      return std::abs(glm::dot(place(point) - middle, border.normal)) <= tolerance() * length;
    });
  }

  // A face beside the border that lies in its plane and looks the other way: the cap would lie on it.
  [[nodiscard]] bool would_double_a_sheet(const Border& border) const {
    return std::ranges::any_of(border.faces, [&](FaceId face) {
      const dvec3& normal = context_.triangles.normal[face];
      return glm::dot(normal, border.normal) <=
             -geom::kParallelCosine * glm::length(normal) * glm::length(border.normal);
    });
  }

  // The smallest border around it in its plane that runs the other way.
  [[nodiscard]] std::optional<std::size_t> smallest_around(const std::vector<Border>& borders,
                                                           std::size_t inner) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (i == inner || borders[i].component != borders[inner].component || !is_around(borders[i], borders[inner])) {
        continue;
      }
      if (!best || glm::length(borders[i].normal) < glm::length(borders[*best].normal)) best = i;
    }
    return best;
  }

  [[nodiscard]] bool is_around(const Border& outer, const Border& inner) const {
    const double out = glm::length(outer.normal), in = glm::length(inner.normal);
    if (in >= out || glm::dot(outer.normal, inner.normal) > -geom::kParallelCosine * in * out) return false;
    const dvec3 offset = place(inner.points[0]) - place(outer.points[0]);
    if (std::abs(glm::dot(offset, outer.normal)) > 2 * tolerance() * out) return false;
    return winds_around(outer, place(inner.points[0]));
  }

  // Parity of the crossings of a ray in the plane, dropping the axis that the normal is nearest to.
  [[nodiscard]] bool winds_around(const Border& outer, const dvec3& point) const {
    const dvec3 n = glm::abs(outer.normal);
    const int dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
    const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
    bool inside = false;
    for (std::size_t i = 0; i < outer.points.size(); ++i) {
      const dvec3 a = place(outer.points[i]), b = place(outer.points[(i + 1) % outer.points.size()]);
      if ((a[v] > point[v]) == (b[v] > point[v])) continue;
      const double at = a[u] + (point[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]);
      if (point[u] < at) inside = !inside;
    }
    return inside;
  }

  [[nodiscard]] FaceId largest_of(const std::vector<FaceId>& faces) const {
    return *std::max_element(faces.begin(), faces.end(), [&](FaceId a, FaceId b) {
      const double x = glm::length(context_.triangles.normal[a]), y = glm::length(context_.triangles.normal[b]);
      return x != y ? x < y : context_.precedes(b, a);
    });
  }

  void add_cap(const std::vector<Border>& borders, std::size_t outer, const std::vector<std::size_t>& holes) {
    scene::Face cap = scene_.faces[largest_of(borders[outer].faces)];
    cap.first_loop = static_cast<std::uint32_t>(scene_.loops.size());
    cap.loop_count = static_cast<std::uint32_t>(1 + holes.size());
    add_loop(borders[outer]);
    for (const std::size_t hole : holes) add_loop(borders[hole]);
    scene_.faces.push_back(cap);
    if (!scene_.smoothing_groups.empty()) scene_.smoothing_groups.push_back(0);
  }

  void add_loop(const Border& border) {
    scene_.loops.push_back(
        {static_cast<std::uint32_t>(scene_.corners.size()), static_cast<std::uint32_t>(border.points.size())});
    for (const PointId point : border.points) scene_.corners.push_back(vertex_of_point_[point]);
    add_no_rows(scene_.attributes.texture_coordinates.row_of_corner);
    add_no_rows(scene_.attributes.normals.row_of_corner);
  }

  // Caps have no texture coordinates and no normals.
  void add_no_rows(std::vector<scene::RowId>& row_of_corner) const {
    if (!row_of_corner.empty()) row_of_corner.resize(scene_.corners.size(), scene::kNoRow);
  }

  scene::Scene& scene_;
  const Context& context_;
  std::vector<scene::VertexId> vertex_of_point_;  ///< one of those at the point
};

}  // namespace

Capped with_planar_caps(scene::Scene scene, const scene::ReadIssues& issues,
                        const std::optional<geom::ToleranceRequest>& tolerance) {
  scene::Scene capped = scene;
  std::string refusal;
  const auto context = validate::build_context(scene, issues, tolerance, refusal);
  const std::size_t caps = context ? Capper(capped, *context).run() : 0;
  return {std::move(capped), caps};
}

}  // namespace rad::repair
