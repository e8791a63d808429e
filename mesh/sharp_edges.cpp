#include "mesh/sharp_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::mesh {
namespace {

using geom::dvec3;
using scene::PointId;

// Elements are four times as dense as patches (two halvings), so that a quarter of the clearance is left to them.
constexpr double kElementParts = 4;
// The lattice is no larger.
constexpr double kFarthest = 2.0 * geom::kLatticeLimit;

/// A face at an edge.
struct Use {
  std::array<PointId, 2> ends{};  ///< ascending
  std::uint32_t face = 0;
  dvec3 inward;  ///< unit, in the plane of the face, perpendicular to the edge
};

class SharpEdges {
 public:
  SharpEdges(const scene::ConformingModel& model, std::span<const FaceFrame> frames, double spacing)
      : model_(model), frames_(frames), spacing_(spacing), sharp_(model.faces.size()) {}

  std::vector<std::vector<SharpEdge>> run() {
    gather();
    for (std::size_t first = 0, last = 0; first < uses_.size(); first = last) {
      while (last < uses_.size() && uses_[last].ends == uses_[first].ends) ++last;
      compare(std::span(uses_).subspan(first, last - first));
    }
    return std::move(sharp_);
  }

 private:
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(model_.points[id]); }

  void gather() {
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
      if (!frames_[f].has_area()) continue;
      for (const scene::Loop& loop : model_.loops_of(model_.faces[f])) {
        const auto ring = model_.corners_of(loop);
        for (std::size_t i = 0; i < ring.size(); ++i) add(f, ring[i], ring[(i + 1) % ring.size()]);
      }
      for (const auto& edge : model_.inner_edges_of(model_.faces[f])) {
        add(f, edge[0], edge[1]);
        add(f, edge[1], edge[0]);
      }
    }
    std::stable_sort(uses_.begin(), uses_.end(), [](const Use& a, const Use& b) { return a.ends < b.ends; });
  }

  void add(std::uint32_t face, PointId from, PointId to) {
    const dvec3 inward = glm::cross(frames_[face].normal(), place(to) - place(from));
    uses_.push_back({{std::min(from, to), std::max(from, to)}, face, glm::normalize(inward)});
  }

  void compare(std::span<const Use> uses) {
    for (const Use& own : uses) {
      double clearance = 0;
      for (const Use& other : uses) {
        if (other.face == own.face || glm::dot(own.inward, other.inward) <= 0) continue;
        const double sine = glm::length(glm::cross(own.inward, other.inward));
        if (sine * width_from(own) <= spacing_) continue;
        clearance = std::max(clearance, kElementParts * spacing_ / sine);
      }
      if (clearance > 0) sharp_[own.face].push_back({own.ends, clearance});
    }
  }

  // How far the face reaches from the edge.
  [[nodiscard]] double width_from(const Use& use) const {
    double width = 0;
    for (const scene::Loop& loop : model_.loops_of(model_.faces[use.face])) {
      for (const PointId id : model_.corners_of(loop)) {
        width = std::max(width, glm::dot(place(id) - place(use.ends[0]), use.inward));
      }
    }
    return width;
  }

  const scene::ConformingModel& model_;
  std::span<const FaceFrame> frames_;
  double spacing_;
  std::vector<Use> uses_;
  std::vector<std::vector<SharpEdge>> sharp_;
};

}  // namespace

namespace {

geom::BoxTree boxes_around(const scene::ConformingModel& model, std::span<const SharpEdge> edges) {
  std::vector<geom::LatticeBox> boxes;
  for (const SharpEdge& edge : edges) {
    const std::array ends{model.points[edge.ends[0]], model.points[edge.ends[1]]};
    boxes.push_back(geom::box_of(ends, static_cast<std::int32_t>(std::min(edge.clearance, kFarthest)) + 1));
  }
  return geom::BoxTree(std::move(boxes));
}

}  // namespace

ClearZone::ClearZone(const scene::ConformingModel& model, std::span<const SharpEdge> edges)
    : edges_(edges), points_(model.points), tree_(boxes_around(model, edges)) {}

bool ClearZone::leaves_out(const geom::LatticePoint& point) const {
  bool clear = true;
  tree_.for_each_meeting(geom::box_of(std::span(&point, 1)), [&](std::uint32_t i) {
    const SharpEdge& edge = edges_[i];
    const dvec3 from = geom::as_vector(points_[edge.ends[0]]), to = geom::as_vector(points_[edge.ends[1]]);
    clear = clear && geom::distance_to_segment(geom::as_vector(point), from, to) >= edge.clearance;
  });
  return clear;
}

std::vector<std::vector<SharpEdge>> sharp_edges(const scene::ConformingModel& model, std::span<const FaceFrame> frames,
                                                double spacing) {
  return SharpEdges(model, frames, spacing).run();
}

}  // namespace rad::mesh
