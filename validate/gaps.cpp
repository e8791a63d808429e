#include "validate/gaps.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <tuple>

#include "geom/triangle_distance.h"

namespace rad::validate {
namespace {

constexpr std::uint32_t kNoTriangle = 0xffffffffu;
// Where more triangles crowd around one vertex, the rest is not looked at.
constexpr int kMostTriangles = 4096;
// Widths and cosines are counted in parts that rounding does not reach: what is equal in truth is equal.
constexpr double kParts = 1 << 16;

double in_parts(double value) { return std::round(value * kParts) / kParts; }

class GapSearch {
 public:
  GapSearch(const Context& context, double reach, const std::vector<bool>& of)
      : context_(context), components_(context.topology.components), reach_(reach), of_(of) {}

  std::vector<ComponentGap> run() {
    std::vector<ComponentGap> gaps;
    if (components_.size() < 2) return gaps;
    first_triangle_.assign(context_.model.points.size(), kNoTriangle);
    shared_.assign(context_.model.points.size(), false);
    find_owners();
    const geom::BoxTree boxes(component_boxes());
    std::mutex mutex;
    // In the order of the tree, so that what is near in space is near in time.
    const auto order = context_.contacts.tree->order();
    constexpr std::size_t kTrianglesPerBlock = 1024;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), kTrianglesPerBlock), [&](const auto& range) {
      std::vector<ComponentGap> own;
      for (std::size_t slot = range.begin(); slot != range.end(); ++slot) look_from(order[slot], boxes, own);
      const std::lock_guard lock(mutex);
      gaps.insert(gaps.end(), own.begin(), own.end());
    });
    std::ranges::sort(gaps, {},
                      [&](const ComponentGap& gap) { return std::pair(gap.vertex, component_of_face(gap.face)); });
    name_vertex_faces(gaps);
    return gaps;
  }

 private:
  [[nodiscard]] std::uint32_t component_of_face(FaceId face) const { return context_.topology.component_of_face[face]; }

  [[nodiscard]] std::uint32_t component_of(std::uint32_t triangle) const {
    return component_of_face(context_.triangles.triangles[triangle].face);
  }

  // At each vertex the face that precedes the others: the same one at all vertices of two faces that coincide.
  void name_vertex_faces(std::vector<ComponentGap>& gaps) const {
    if (gaps.empty()) return;
    std::vector<std::uint32_t> first_gap(first_triangle_.size(), kNoTriangle);
    for (auto i = static_cast<std::uint32_t>(gaps.size()); i-- > 0;) first_gap[gaps[i].vertex] = i;
    for (const FaceTriangle& triangle : context_.triangles.triangles) {
      for (const PointId point : triangle.points) {
        for (std::uint32_t i = first_gap[point]; i < gaps.size() && gaps[i].vertex == point; ++i) {
          const bool other = triangle.face != gaps[i].vertex_face;
          if (other && context_.precedes(triangle.face, gaps[i].vertex_face)) gaps[i].vertex_face = triangle.face;
        }
      }
    }
  }

  // The first triangle by place at each vertex, and which vertices components share.
  void find_owners() {
    const auto& triangles = context_.triangles.triangles;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      for (const PointId point : triangles[i].points) {
        std::uint32_t& first = first_triangle_[point];
        if (first == kNoTriangle) {
          first = i;
          continue;
        }
        if (component_of(first) != component_of(i)) shared_[point] = true;
        if (triangles[i].points < triangles[first].points) first = i;
      }
    }
  }

  [[nodiscard]] std::vector<geom::LatticeBox> component_boxes() const {
    std::vector<geom::LatticeBox> boxes;
    const auto inflation = static_cast<std::int32_t>(std::ceil(reach_));
    for (const Component& component : components_) {
      boxes.push_back(geom::box_of(std::array{component.low, component.high}, inflation));
    }
    return boxes;
  }

  // Empty components have no box of their own; theirs holds the origin and does no harm.
  [[nodiscard]] bool near_another(const geom::LatticeBox& point, std::uint32_t own, const geom::BoxTree& boxes) const {
    bool near = false;
    boxes.for_each_meeting(point, [&](std::uint32_t other) { near = near || other != own; });
    return near;
  }

  // From the vertices of which this is the first triangle.
  void look_from(std::uint32_t triangle, const geom::BoxTree& boxes, std::vector<ComponentGap>& gaps) const {
    if (!of_[component_of(triangle)]) return;
    for (const PointId point : context_.triangles.triangles[triangle].points) {
      if (first_triangle_[point] == triangle && !shared_[point]) look_around(point, triangle, boxes, gaps);
    }
  }

  void look_around(PointId point, std::uint32_t first, const geom::BoxTree& boxes,
                   std::vector<ComponentGap>& gaps) const {
    const geom::LatticePoint& place = context_.model.points[point];
    const std::uint32_t own = component_of(first);
    if (!near_another(geom::box_of(std::span(&place, 1)), own, boxes)) return;
    const auto inflation = static_cast<std::int32_t>(std::ceil(reach_));
    std::vector<ComponentGap> nearest;  // one for each other component
    int seen = 0;
    context_.contacts.tree->for_each_meeting(geom::box_of(std::span(&place, 1), inflation), [&](std::uint32_t i) {
      if (component_of(i) != own && ++seen <= kMostTriangles) approach(place, point, first, i, nearest);
    });
    const bool touches = std::ranges::any_of(
        nearest, [&](const ComponentGap& gap) { return gap.width <= static_cast<double>(context_.tolerance.pitches); });
    if (!touches) gaps.insert(gaps.end(), nearest.begin(), nearest.end());
  }

  void approach(const geom::LatticePoint& place, PointId point, std::uint32_t own, std::uint32_t triangle,
                std::vector<ComponentGap>& nearest) const {
    const geom::dvec3 foot = geom::nearest_point(context_.triangles.geometry[triangle].points, place);
    const double width = in_parts(glm::distance(geom::as_vector(place), foot));
    if (width >= reach_) return;
    const FaceId own_face = context_.triangles.triangles[own].face, face = context_.triangles.triangles[triangle].face;
    const ComponentGap candidate{point, own_face, face,
                                 foot,  width,    glm::dot(unit_normal(own_face), unit_normal(face))};
    const auto same = std::ranges::find_if(
        nearest, [&](const ComponentGap& gap) { return component_of_face(gap.face) == component_of_face(face); });
    if (same == nearest.end()) {
      nearest.push_back(candidate);
    } else if (is_nearer(candidate, *same)) {
      *same = candidate;
    }
  }

  // Of places at the same distance that of the face which is most nearly parallel, then the first place, then the first
  // face.
  [[nodiscard]] bool is_nearer(const ComponentGap& a, const ComponentGap& b) const {
    const auto key = [](const ComponentGap& gap) {
      return std::tuple(gap.width, -in_parts(std::abs(gap.cosine)), in_parts(gap.foot.x), in_parts(gap.foot.y),
                        in_parts(gap.foot.z));
    };
    return key(a) != key(b) ? key(a) < key(b) : a.face != b.face && context_.precedes(a.face, b.face);
  }

  [[nodiscard]] dvec3 unit_normal(FaceId face) const { return glm::normalize(context_.triangles.normal[face]); }

  const Context& context_;
  const std::vector<Component>& components_;
  double reach_;
  const std::vector<bool>& of_;
  std::vector<std::uint32_t> first_triangle_;  ///< per point
  std::vector<bool> shared_;                   ///< per point: by several components
};

// Per component among `of` the number of its vertices.
std::vector<std::uint32_t> vertex_counts(const Context& context, const std::vector<bool>& of) {
  std::vector<std::array<std::uint32_t, 2>> owned;
  for (const FaceTriangle& triangle : context.triangles.triangles) {
    const std::uint32_t component = context.topology.component_of_face[triangle.face];
    if (!of[component]) continue;
    for (const PointId point : triangle.points) owned.push_back({component, point});
  }
  std::ranges::sort(owned);
  owned.erase(std::unique(owned.begin(), owned.end()), owned.end());
  std::vector<std::uint32_t> counts(context.topology.components.size(), 0);
  for (const auto& [component, point] : owned) ++counts[component];
  return counts;
}

// Cosine of 1 degree: as flat as what is laid on something.
constexpr double kParallel = 0.9998476951563913;

}  // namespace

std::vector<ComponentGap> find_gaps(const Context& context, double reach, const std::vector<bool>& of) {
  return GapSearch(context, reach, of).run();
}

std::vector<bool> open_flat_sheets(const Context& context) {
  const auto& topology = context.topology;
  std::vector<bool> flat;
  for (const Component& component : topology.components) flat.push_back(component.open_subedges > 0);
  std::vector<FaceId> first(flat.size(), kNoFace);
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    const std::uint32_t component = topology.component_of_face[face];
    if (component == kNoComponent || !flat[component] || !context.is_sound(face)) continue;
    if (first[component] == kNoFace) first[component] = face;
    const dvec3& own = context.triangles.normal[face];
    const dvec3& other = context.triangles.normal[first[component]];
    if (std::abs(glm::dot(own, other)) < kParallel * glm::length(own) * glm::length(other)) flat[component] = false;
  }
  return flat;
}

std::vector<bool> decals_among(const Context& context, const std::vector<bool>& sheets,
                               const std::vector<ComponentGap>& gaps) {
  std::vector<bool> decal(sheets.size(), false);
  std::vector<std::uint32_t> over(sheets.size(), 0);
  bool any = false;
  PointId last = scene::kNoPoint;
  for (const ComponentGap& gap : gaps) {
    const std::uint32_t own = context.topology.component_of_face[gap.vertex_face];
    if (!sheets[own] || std::abs(gap.cosine) < kParallel || gap.vertex == last) continue;
    ++over[own];
    last = gap.vertex;
    any = true;
  }
  if (!any) return decal;
  const std::vector<std::uint32_t> counts = vertex_counts(context, sheets);
  for (std::size_t i = 0; i < decal.size(); ++i) decal[i] = over[i] > 0 && over[i] == counts[i];
  return decal;
}

std::vector<ComponentGap> gaps_of_edges(const Context& context, const std::vector<ComponentGap>& gaps) {
  if (gaps.empty()) return {};
  std::vector<std::uint32_t> first_gap(context.model.points.size(), static_cast<std::uint32_t>(gaps.size()));
  for (auto i = static_cast<std::uint32_t>(gaps.size()); i-- > 0;) first_gap[gaps[i].vertex] = i;
  const auto& component_of = context.topology.component_of_face;
  const auto& points = context.model.points;
  std::vector<bool> kept(gaps.size(), false);
  for (const Subedge& subedge : context.topology.subedges) {
    const auto squared = static_cast<double>(geom::squared_distance(points[subedge.a], points[subedge.b]));
    for (std::uint32_t a = first_gap[subedge.a]; a < gaps.size() && gaps[a].vertex == subedge.a; ++a) {
      for (std::uint32_t b = first_gap[subedge.b]; b < gaps.size() && gaps[b].vertex == subedge.b; ++b) {
        if (component_of[gaps[a].face] != component_of[gaps[b].face]) continue;
        // Rounding of the ends to the lattice does not decide about squares.
        const double width = std::max(gaps[a].width, gaps[b].width) - 1;
        if (squared >= width * width) kept[a] = kept[b] = true;
      }
    }
  }
  std::vector<ComponentGap> result;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (kept[i]) result.push_back(gaps[i]);
  }
  return result;
}

}  // namespace rad::validate
