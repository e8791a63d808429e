#include "bake/light_charts.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <tuple>

#include "bake/flat_hull.h"

namespace rad::bake {
namespace {

using mesh::NodeId;
using mesh::Patch;
using mesh::RadiosityMesh;

/// An edge of a patch, by its nodes in the direction of the patch.
struct PatchEdge {
  NodeId from = 0;
  NodeId to = 0;
  PatchId patch = 0;
};

struct Link {
  PatchId a = 0;
  PatchId b = 0;
};

std::vector<PatchEdge> edges_of(const RadiosityMesh& mesh, const std::vector<PatchId>& patches) {
  std::vector<PatchEdge> edges;
  for (const PatchId id : patches) {
    const auto corners = mesh.patches[id].corners.all();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges.push_back({corners[i], corners[(i + 1) % corners.size()], id});
    }
  }
  return edges;
}

bool same_plane(const Patch& a, const Patch& b) { return a.material == b.material && a.normal == b.normal; }

// Pairs of patches of one plane with two nodes in common, in opposite order.
std::vector<Link> links_among(const RadiosityMesh& mesh, std::vector<PatchEdge> edges) {
  const auto ends = [](const PatchEdge& edge) { return std::minmax(edge.from, edge.to); };
  std::ranges::sort(edges, [&](const PatchEdge& a, const PatchEdge& b) {
    return std::tuple(ends(a), a.patch) < std::tuple(ends(b), b.patch);
  });
  std::vector<Link> links;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const PatchEdge &a = edges[i - 1], &b = edges[i];
    if (a.from != b.to || a.to != b.from) continue;
    if (same_plane(mesh.patches[a.patch], mesh.patches[b.patch])) links.push_back({a.patch, b.patch});
  }
  return links;
}

/// Groups patches that links connect.
class Parts {
 public:
  explicit Parts(const std::vector<PatchId>& patches) : patches_(patches), parent_(patches.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  void join(const Link& link) {
    const std::size_t a = root(place(link.a)), b = root(place(link.b));
    parent_[std::max(a, b)] = std::min(a, b);
  }
  // Each ascending, by their first patches.
  std::vector<std::vector<PatchId>> all() {
    std::vector<std::vector<PatchId>> parts;
    std::vector<std::size_t> part(patches_.size());
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const std::size_t first = root(i);
      if (first == i) {
        part[i] = parts.size();
        parts.emplace_back();
      }
      parts[part[first]].push_back(patches_[i]);
    }
    return parts;
  }

 private:
  [[nodiscard]] std::size_t place(PatchId patch) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(patches_, patch) - patches_.begin());
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  const std::vector<PatchId>& patches_;
  std::vector<std::size_t> parent_;
};

// An edge without a link whose other side, at the same two places, belongs to the part too.
std::optional<PatchEdge> slit_in(const RadiosityMesh& mesh, const std::vector<PatchEdge>& edges) {
  struct Placed {
    std::array<double, 6> ends;  ///< the lesser place first
    PatchEdge edge;
  };
  std::vector<Placed> placed;
  for (const PatchEdge& edge : edges) {
    const dvec3 &a = mesh.nodes[edge.from].position, &b = mesh.nodes[edge.to].position;
    const std::array<double, 3> from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
    const auto& [low, high] = std::minmax(from, to);
    placed.push_back({{low[0], low[1], low[2], high[0], high[1], high[2]}, edge});
  }
  std::ranges::sort(placed, [](const Placed& a, const Placed& b) {
    return std::tuple(a.ends, a.edge.patch) < std::tuple(b.ends, b.edge.patch);
  });
  std::optional<PatchEdge> first;
  for (std::size_t i = 1; i < placed.size(); ++i) {
    const PatchEdge &a = placed[i - 1].edge, &b = placed[i].edge;
    if (placed[i - 1].ends != placed[i].ends || (a.from == b.to && a.to == b.from)) continue;
    if (!first || a.patch < first->patch) first = a;
  }
  return first;
}

class Cutting {
 public:
  explicit Cutting(const RadiosityMesh& mesh) : mesh_(mesh) {}

  std::vector<std::vector<PatchId>> run() {
    std::vector<PatchId> all(mesh_.patches.size());
    std::iota(all.begin(), all.end(), PatchId{0});
    const std::vector<Link> links = links_among(mesh_, edges_of(mesh_, all));
    Parts parts(all);
    for (const Link& link : links) parts.join(link);
    open_ = parts.all();
    while (!open_.empty()) {
      std::vector<PatchId> part = std::move(open_.back());
      open_.pop_back();
      cut(std::move(part));
    }
    std::ranges::sort(done_, {}, [](const std::vector<PatchId>& part) { return part.front(); });
    return std::move(done_);
  }

 private:
  // The two patches at a slit lie on different sides of its line, so every cut leaves smaller parts.
  void cut(std::vector<PatchId> part) {
    const std::vector<PatchEdge> edges = edges_of(mesh_, part);
    const auto slit = slit_in(mesh_, edges);
    if (!slit) return done_.push_back(std::move(part));
    const dvec3& from = mesh_.nodes[slit->from].position;
    const dvec3 across = glm::cross(mesh_.patches[slit->patch].normal, mesh_.nodes[slit->to].position - from);
    Parts parts(part);
    for (const Link& link : links_among(mesh_, edges)) {
      if (is_left(link.a, from, across) == is_left(link.b, from, across)) parts.join(link);
    }
    for (auto& smaller : parts.all()) open_.push_back(std::move(smaller));
  }

  [[nodiscard]] bool is_left(PatchId patch, const dvec3& from, const dvec3& across) const {
    double sum = 0;
    for (const NodeId node : mesh_.patches[patch].corners.all()) {
      sum += glm::dot(mesh_.nodes[node].position - from, across);
    }
    return sum > 0;
  }

  const RadiosityMesh& mesh_;
  std::vector<std::vector<PatchId>> open_;
  std::vector<std::vector<PatchId>> done_;
};

LightChart chart_of(const RadiosityMesh& mesh, std::vector<PatchId> patches) {
  LightChart chart;
  const Patch& first = mesh.patches[patches.front()];
  chart.origin = mesh.nodes[first.corners.node[0]].position;
  chart.right = glm::normalize(mesh.nodes[first.corners.node[1]].position - chart.origin);
  chart.down = glm::cross(chart.right, first.normal);
  std::vector<dvec2> points;
  for (const PatchId patch : patches) {
    for (const NodeId node : mesh.patches[patch].corners.all()) {
      points.push_back(chart.in_plane(mesh.nodes[node].position));
    }
  }
  const FlatRectangle around = least_rectangle(points);
  const dvec3 right = chart.right * around.along.x + chart.down * around.along.y;
  const dvec3 down = chart.down * around.along.x - chart.right * around.along.y;
  chart.origin += chart.right * around.corner.x + chart.down * around.corner.y;
  chart.right = right;
  chart.down = down;
  chart.width = around.length;
  chart.height = around.breadth;
  chart.patches = std::move(patches);
  return chart;
}

}  // namespace

dvec2 LightChart::in_plane(const dvec3& position) const {
  return {glm::dot(position - origin, right), glm::dot(position - origin, down)};
}

std::vector<LightChart> light_charts(const RadiosityMesh& mesh) {
  std::vector<LightChart> charts;
  for (auto& part : Cutting(mesh).run()) charts.push_back(chart_of(mesh, std::move(part)));
  return charts;
}

}  // namespace rad::bake
