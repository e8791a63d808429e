#include "mesh/crossed_leaves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "geom/planar_shape.h"
#include "mesh/patch_edges.h"

namespace rad::mesh {
namespace {

using geom::PlanePoint;

/// A line in an orthonormal frame of its plane.
class LineOnFace {
 public:
  LineOnFace(const ElementMesh& mesh, const ShadowLine& line, double reach)
      : mesh_(mesh), origin_(line.end[0]), reach_(reach) {
    const dvec3& normal = mesh.source(line.patch[0]).normal;
    const dvec3 aside = std::abs(normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    u_ = glm::normalize(glm::cross(aside, normal));
    v_ = glm::cross(normal, u_);
    end_ = flat(line.end[1]);
  }

  /// By axes that would separate: never misses an element, and takes in some near its corners.
  [[nodiscard]] bool crosses(ElementId element) const {
    const Corners corners = mesh_.corners(element);
    std::array<PlanePoint, 4> place;
    for (std::uint32_t i = 0; i < corners.count; ++i) {
      place[i] = flat(geom::as_vector(mesh_.points()[mesh_.point_of(corners.node[i])]));
    }
    const std::span<const PlanePoint> ring = std::span(place).first(corners.count);
    if (apart(ring, {-end_.y, end_.x})) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (apart(ring, {b.y - a.y, a.x - b.x})) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] PlanePoint flat(const dvec3& place) const {
    return {glm::dot(place - origin_, u_), glm::dot(place - origin_, v_)};
  }

  [[nodiscard]] bool apart(std::span<const PlanePoint> ring, const PlanePoint& axis) const {
    const double length = std::hypot(axis.x, axis.y);
    if (length == 0) return false;
    double low = INFINITY, high = -INFINITY;
    for (const PlanePoint& p : ring) {
      const double at = (p.x * axis.x + p.y * axis.y) / length;
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const double end = (end_.x * axis.x + end_.y * axis.y) / length;
    return std::max(0.0, end) + reach_ < low || std::min(0.0, end) - reach_ > high;
  }

  const ElementMesh& mesh_;
  dvec3 origin_;
  double reach_;
  dvec3 u_{1, 0, 0}, v_{0, 1, 0};
  PlanePoint end_;
};

void set(std::vector<std::uint8_t>& marked, ElementId leaf) {
  std::atomic_ref(marked[leaf]).store(1, std::memory_order_relaxed);
}

class Walk {
 public:
  Walk(const ElementMesh& mesh, const LineOnFace& line, std::vector<std::uint8_t>& marked)
      : mesh_(mesh), line_(line), marked_(marked) {}

  void from(PatchId patch) {
    reach(patch);
    while (!open_.empty()) {
      const PatchId here = open_.back();
      open_.pop_back();
      descend(here);
      const std::uint32_t edges = mesh_.corners(here).count;
      for (std::uint32_t edge = 0; edge < edges; ++edge) {
        const ElementId next = mesh_.patch_across(here, edge);
        if (next != kNoElement && mesh_.source(next).face == mesh_.source(here).face && line_.crosses(next))
          reach(next);
      }
    }
  }

 private:
  void reach(PatchId patch) {
    if (std::find(seen_.begin(), seen_.end(), patch) != seen_.end()) return;
    seen_.push_back(patch);
    open_.push_back(patch);
  }

  void descend(ElementId element) {
    if (!line_.crosses(element)) return;
    if (mesh_.is_leaf(element)) return set(marked_, element);
    const ElementId first = mesh_.first_child(element);
    for (ElementId slot = 0; slot < 4; ++slot) descend(first + slot);
  }

  const ElementMesh& mesh_;
  const LineOnFace& line_;
  std::vector<std::uint8_t>& marked_;
  std::vector<PatchId> seen_, open_;
};

void mark_along(const ElementMesh& mesh, ElementId element, std::uint32_t edge, std::vector<std::uint8_t>& marked) {
  if (mesh.is_leaf(element)) return set(marked, element);
  const ElementId first = mesh.first_child(element);
  const std::uint32_t count = mesh.corners(element).count;
  mark_along(mesh, first + edge, edge, marked);
  mark_along(mesh, first + (edge + 1) % count, edge, marked);
}

}  // namespace

void mark_crossed(const ElementMesh& mesh, std::span<const ShadowLine> lines, double reach,
                  std::vector<std::uint8_t>& marked) {
  constexpr std::size_t kGrain = 64;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lines.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        const LineOnFace line(mesh, lines[i], reach);
                        Walk walk(mesh, line, marked);
                        for (const PatchId patch : lines[i].patch) walk.from(patch);
                      }
                    });
}

void mark_at_contacts(const ElementMesh& mesh, std::vector<std::uint8_t>& marked) {
  for (const PatchEdge& edge : crease_edges(mesh)) {
    if (edge.count < 3) continue;
    for (std::uint32_t i = 0; i < edge.count; ++i) mark_along(mesh, edge.patch[i], edge.edge[i], marked);
  }
}

}  // namespace rad::mesh
