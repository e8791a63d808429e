#include "mesh/shadow_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "mesh/patch_edges.h"

namespace rad::mesh {
namespace {

// Rays pass an edge at this many T: clear of what the weld may have moved, within the least gap of contacts.
constexpr double kBeside = 2;

// Along an edge, for each finest length: a border is up to so much longer than what throws it.
constexpr double kProbes = 3;
// Pitches between the borders on two faces, in the plane across the light's way.
constexpr double kLeastGap = 1;

/// Where the border that a point of an edge throws lies.
struct Thrown {
  bool found = false;
  PatchId patch = 0;
  dvec3 place{0, 0, 0};
};

class EdgeTracer {
 public:
  EdgeTracer(const ElementMesh& mesh, const PatchRays& rays, const LightSample& light, double finest,
             std::vector<ShadowLine>& lines)
      : mesh_(mesh),
        rays_(rays),
        light_(light),
        finest_(finest),
        beside_(kBeside * static_cast<double>(mesh.tolerance().pitches)),
        lines_(lines) {}

  void trace(const PatchEdge& edge) {
    edge_ = &edge;
    from_ = geom::as_vector(mesh_.points()[edge.ends[0]]);
    to_ = geom::as_vector(mesh_.points()[edge.ends[1]]);
    if (!may_be_outline()) return;
    const auto steps = static_cast<int>(std::ceil(kProbes * glm::length(to_ - from_) / finest_)) + 1;
    Thrown before = thrown_at(0);
    for (int step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const Thrown here = thrown_at(share);
      connect(static_cast<double>(step - 1) / steps, before, share, here);
      before = here;
    }
  }

 private:
  [[nodiscard]] dvec3 place(double share) const { return from_ + (to_ - from_) * share; }

  // Rays keep away from the ends, where they would meet what else is there; the border runs to the ends.
  [[nodiscard]] dvec3 probe(double share) const {
    const double inset = std::min(0.1, beside_ / glm::length(to_ - from_));
    return place(std::clamp(share, inset, 1 - inset));
  }

  // Of two faces that both look at the light, or both away, none ends at the edge.
  [[nodiscard]] bool may_be_outline() const {
    const dvec3 way = light_.place - from_;
    if (std::max(glm::dot(from_ - light_.place, light_.normal), glm::dot(to_ - light_.place, light_.normal)) <= 0) {
      return false;
    }
    if (edge_->count != 2) return true;
    const double a = glm::dot(mesh_.source(edge_->patch[0]).normal, way);
    const double b = glm::dot(mesh_.source(edge_->patch[1]).normal, way);
    return a * b <= 0 || edge_->same_way;
  }

  [[nodiscard]] bool is_own(PatchId patch) const {
    const std::uint32_t face = mesh_.source(patch).face;
    for (std::uint32_t i = 0; i < edge_->count; ++i) {
      if (mesh_.source(edge_->patch[i]).face == face) return true;
    }
    return false;
  }

  // An edge throws a border where a ray on one side of it is stopped by one of its own faces or by what lies before
  // them, and a ray on the other passes. A face seen so sidelong that the ray misses it has another outline within the
  // ray's distance of the edge.
  [[nodiscard]] Thrown thrown_at(double share) const {
    const dvec3 point = probe(share), way = point - light_.place;
    if (glm::dot(way, light_.normal) <= 0) return {};
    const double distance = glm::length(way);
    if (rays_.blocked(light_.place, way / distance, distance - beside_)) return {};
    const dvec3 across = glm::cross(to_ - from_, way);
    if (glm::length(across) == 0) return {};
    const dvec3 side = glm::normalize(across) * beside_;
    int stopped = 0;
    for (const double sign : {1.0, -1.0}) {
      const auto hit = rays_.nearest(light_.place, glm::normalize(way + side * sign));
      if (hit && (is_own(hit->patch) || hit->distance < distance)) ++stopped;
    }
    if (stopped != 1) return {};
    const std::optional<PatchId> behind = first_behind(point, way / distance);
    return behind ? onto(*behind, place(share) - light_.place) : Thrown{};
  }

  // What a ray that grazes the edge meets; its own faces, which it leaves at the edge, are met by rounding only.
  [[nodiscard]] std::optional<PatchId> first_behind(dvec3 from, const dvec3& direction) const {
    for (std::uint32_t skipped = 0; skipped <= PatchEdge::kMost; ++skipped) {
      from += direction * beside_;
      const auto hit = rays_.nearest(from, direction);
      if (!hit) return std::nullopt;
      if (!is_own(hit->patch)) return hit->patch;
      from += direction * hit->distance;
    }
    return std::nullopt;
  }

  // The exact border: where the line through light and edge meets the plane of the patch.
  [[nodiscard]] Thrown onto(PatchId patch, const dvec3& way) const {
    const dvec3& normal = mesh_.source(patch).normal;
    const double slope = glm::dot(normal, way);
    if (slope >= 0) return {};  // its back
    const dvec3 corner = geom::as_vector(mesh_.points()[mesh_.point_of(mesh_.corners(patch).node[0])]);
    return {true, patch, light_.place + way * (glm::dot(normal, corner - light_.place) / slope)};
  }

  void connect(double from, const Thrown& a, double to, const Thrown& b) {
    if (!a.found && !b.found) return;
    const bool together = a.found && b.found && mesh_.source(a.patch).face == mesh_.source(b.patch).face;
    if (together && glm::length(a.place - b.place) <= 2 * finest_) {
      lines_.push_back({{a.place, b.place}, {a.patch, b.patch}});
      return;
    }
    // What is left between the two is less than points are rounded by. (Not T: on a face seen sidelong it may be long.)
    const double length = (to - from) * glm::length(to_ - from_), near = glm::length(place(from) - light_.place);
    double magnified = length;
    for (const Thrown& thrown : {a, b}) {
      if (thrown.found) magnified = std::max(magnified, length * glm::length(thrown.place - light_.place) / near);
    }
    if (magnified < kLeastGap) {
      for (const Thrown& thrown : {a, b}) {
        if (thrown.found) lines_.push_back({{thrown.place, thrown.place}, {thrown.patch, thrown.patch}});
      }
      return;
    }
    const double middle = (from + to) / 2;
    const Thrown between = thrown_at(middle);
    connect(from, a, middle, between);
    connect(middle, between, to, b);
  }

  const ElementMesh& mesh_;
  const PatchRays& rays_;
  const LightSample& light_;
  double finest_;
  double beside_;
  std::vector<ShadowLine>& lines_;
  const PatchEdge* edge_ = nullptr;
  dvec3 from_{0, 0, 0};
  dvec3 to_{0, 0, 0};
};

}  // namespace

std::vector<ShadowLine> shadow_lines(const ElementMesh& mesh, const PatchRays& rays,
                                     std::span<const LightSample> lights, double finest) {
  constexpr std::size_t kChunk = 256;
  const std::vector<PatchEdge> edges = crease_edges(mesh);
  const std::size_t chunks = (edges.size() + kChunk - 1) / kChunk;
  std::vector<std::vector<ShadowLine>> found(chunks * lights.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t task) {
    EdgeTracer tracer(mesh, rays, lights[task / chunks], finest, found[task]);
    const std::size_t first = task % chunks * kChunk;
    for (std::size_t e = first; e < std::min(edges.size(), first + kChunk); ++e) tracer.trace(edges[e]);
  });
  std::vector<ShadowLine> lines;
  for (const auto& part : found) lines.insert(lines.end(), part.begin(), part.end());
  return lines;
}

}  // namespace rad::mesh
